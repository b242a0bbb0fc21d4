#include "nodes/common/ros_parameters.h"

#include <ros/param.h>

#include <string>

#include "omega_slam/config/yaml_value.h"

namespace omega_slam {
namespace {

using XmlRpc::XmlRpcValue;

YAML::Node scalar(const std::string& text, const std::string& tag) {
  YAML::Node node(text);
  node.SetTag(tag);
  return node;
}

YAML::Node listFrom(const XmlRpcValue& value) {
  YAML::Node node(YAML::NodeType::Sequence);
  for (int i = 0; i < value.size(); ++i) {
    node.push_back(yamlFromXmlRpc(value[i]));
  }
  return node;
}

YAML::Node mapFrom(const XmlRpcValue& value) {
  YAML::Node node(YAML::NodeType::Map);
  for (const auto& [key, member] : value) {
    node.force_insert(key, yamlFromXmlRpc(member));
  }
  return node;
}

}  // namespace

YAML::Node yamlFromXmlRpc(const XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<const bool&>(value) ? "true" : "false");
    case XmlRpcValue::TypeInt:
      return YAML::Node(std::to_string(static_cast<const int&>(value)));
    case XmlRpcValue::TypeDouble:
      return YAML::Node(config::numberText(static_cast<const double&>(value)));
    case XmlRpcValue::TypeString:
      return scalar(static_cast<const std::string&>(value), "!");
    case XmlRpcValue::TypeArray:
      return listFrom(value);
    case XmlRpcValue::TypeStruct:
      return mapFrom(value);
    case XmlRpcValue::TypeDateTime:
      return scalar("a date", "!date");
    case XmlRpcValue::TypeBase64:
      return scalar("binary data", "!binary");
    case XmlRpcValue::TypeInvalid:
      break;
  }
  return YAML::Node(YAML::NodeType::Null);
}

config::ParameterReader privateParameters(const ros::NodeHandle& private_handle) {
  const std::string& name = private_handle.getNamespace();
  XmlRpcValue tree;
  const bool any = ros::param::get(name, tree);
  return {any ? yamlFromXmlRpc(tree) : YAML::Node(YAML::NodeType::Map), name.substr(1)};
}

}  // namespace omega_slam

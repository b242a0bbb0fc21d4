#pragma once

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include "omega_slam/config/parameter_reader.h"

namespace omega_slam {

/// A ROS parameter, or a tree of them, as YAML. Types stay distinct: strings are quoted, doubles
/// keep all their digits. Dates and binary data become scalars of a foreign kind, which a
/// ParameterReader refuses wherever they stand.
[[nodiscard]] YAML::Node yamlFromXmlRpc(const XmlRpc::XmlRpcValue& value);

/// A reader of a node's private parameters, whose messages name them in full, without the leading
/// slash. The parameter server is asked once, here.
[[nodiscard]] config::ParameterReader privateParameters(const ros::NodeHandle& private_handle);

}  // namespace omega_slam

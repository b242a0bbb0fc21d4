#include "nodes/common/ros_parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "omega_slam/config/yaml_value.h"

namespace omega_slam {
namespace {

using config::ConfigurationError;
using config::kindOf;
using config::numberOf;
using config::ParameterReader;
using config::ValueKind;
using XmlRpc::XmlRpcValue;

TEST(YamlFromXmlRpc, KeepsTheTypesDistinct) {
  EXPECT_EQ(kindOf(yamlFromXmlRpc(true)), ValueKind::kBool);
  EXPECT_EQ(kindOf(yamlFromXmlRpc(7)), ValueKind::kInteger);
  EXPECT_EQ(kindOf(yamlFromXmlRpc(0.25)), ValueKind::kReal);
  for (const char* text : {"odom", "true", "7", "0.25", "", "~"}) {
    EXPECT_EQ(kindOf(yamlFromXmlRpc(text)), ValueKind::kText) << text;
    EXPECT_EQ(yamlFromXmlRpc(text).Scalar(), text);
  }
}

TEST(YamlFromXmlRpc, DoublesKeepEveryDigit) {
  for (const double value : {0.1, 1.0 / 3.0, -2.0, 1e-6, 1e300, 5e-324}) {
    EXPECT_EQ(numberOf(yamlFromXmlRpc(value)), value);
  }
  EXPECT_TRUE(std::isnan(numberOf(yamlFromXmlRpc(std::nan("")))));
  EXPECT_EQ(numberOf(yamlFromXmlRpc(-std::numeric_limits<double>::infinity())),
            -std::numeric_limits<double>::infinity());
}

TEST(YamlFromXmlRpc, TreeIsReadLikeAFile) {
  XmlRpcValue tree;
  tree["keyframe_translation"] = 0.3;
  tree["base_frame"] = "base_link";
  tree["icp"]["max_iterations"] = 30;
  tree["laser_pose"][0] = 1;
  tree["laser_pose"][1] = 0.5;
  ParameterReader reader(yamlFromXmlRpc(tree), "scan_matcher");
  double translation = 0.0;
  std::string frame;
  int iterations = 0;
  std::vector<double> pose;
  reader.read("keyframe_translation", translation);
  reader.read("base_frame", frame);
  reader.group("icp").read("max_iterations", iterations);
  reader.read("laser_pose", pose);
  EXPECT_NO_THROW(reader.finish());
  EXPECT_EQ(translation, 0.3);
  EXPECT_EQ(frame, "base_link");
  EXPECT_EQ(iterations, 30);
  EXPECT_EQ(pose, (std::vector<double>{1.0, 0.5}));
}

TEST(YamlFromXmlRpc, DatesAndBinariesFitNowhere) {
  std::tm date{};
  char bytes[] = {'1', '2'};
  for (const XmlRpcValue& value : {XmlRpcValue(&date), XmlRpcValue(bytes, 2), XmlRpcValue()}) {
    XmlRpcValue tree;
    tree["text"] = value;
    ParameterReader reader(yamlFromXmlRpc(tree), "node");
    std::string text;
    reader.read("text", text);
    EXPECT_THROW(reader.finish(), ConfigurationError);
  }
}

}  // namespace
}  // namespace omega_slam

#pragma once

#include <ros/console.h>
#include <ros/node_handle.h>

#include <string>

#include "nodes/common/ros_parameters.h"
#include "omega_slam/config/slam_config.h"

namespace omega_slam {

/// Says at the start what is in force, so that a log tells how its run was configured.
inline void logParameters(const config::ParameterReader& reader) {
  std::string text;
  for (const config::Parameter& parameter : reader.parameters()) {
    text += "\n  " + parameter.key + ": " + parameter.value;
  }
  ROS_INFO_STREAM("Parameters:" << text);
}

/// A node's configuration, from its private parameters.
/// @throws config::ConfigurationError with a sentence for each fault
template <class Config>
[[nodiscard]] Config loadConfig(const ros::NodeHandle& private_nh) {
  config::ParameterReader reader = privateParameters(private_nh);
  Config result;
  read(reader, result);  // the one beside Config, wherever that is
  reader.finish();
  logParameters(reader);
  return result;
}

}  // namespace omega_slam

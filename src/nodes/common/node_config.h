#pragma once

#include <ros/console.h>
#include <ros/node_handle.h>

#include <string>

#include "nodes/common/ros_parameters.h"
#include "omega_slam/config/slam_config.h"

namespace omega_slam {

/// Says at the start what is in force, so that a log tells how its run was configured.
inline void logParameters(const config::ParameterReader& reader, ros::console::Level level) {
  std::string text;
  for (const config::Parameter& parameter : reader.parameters()) {
    text += "\n  " + parameter.key + ": " + parameter.value;
  }
  ROS_LOG_STREAM(level, ROSCONSOLE_DEFAULT_NAME, "Parameters:" << text);
}

/// A node's configuration, from its private parameters, which are logged.
/// @param level of that log; lower for a node whose terminal is its display
/// @throws config::ConfigurationError with a sentence for each fault
template <class Config>
[[nodiscard]] Config loadConfig(const ros::NodeHandle& private_nh,
                                ros::console::Level level = ros::console::levels::Info) {
  config::ParameterReader reader = privateParameters(private_nh);
  Config result;
  read(reader, result);  // the one beside Config, wherever that is
  reader.finish();
  logParameters(reader, level);
  return result;
}

}  // namespace omega_slam

#pragma once

#include <ros/node_handle.h>

#include "nodes/common/ros_parameters.h"
#include "omega_slam/config/slam_config.h"

namespace omega_slam {

/// A node's configuration, from its private parameters.
/// @throws config::ConfigurationError with a sentence for each fault
template <class Config>
[[nodiscard]] Config loadConfig(const ros::NodeHandle& private_nh) {
  config::ParameterReader reader = privateParameters(private_nh);
  Config result;
  read(reader, result);  // the one beside Config, wherever that is
  reader.finish();
  return result;
}

}  // namespace omega_slam

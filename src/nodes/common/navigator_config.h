#pragma once

#include <ros/node_handle.h>

#include <string>

#include "omega_slam/config/parameter_reader.h"
#include "omega_slam/navigation/footprint.h"
#include "omega_slam/navigation/navigator.h"
#include "omega_slam/sensing/scan_intake.h"

namespace omega_slam {

/// Parameters of the node navigator; config/navigation.yaml explains them.
struct NavigatorNodeConfig {
  navigation::NavigatorConfig navigator;
  sensing::ScanIntakeConfig scans;
  std::string map_frame{"map"};
  std::string base_frame{"base_footprint"};
  double control_rate{10.0};                     ///< [Hz] of commands
  double costmap_interval{1.0};                  ///< [s] between costmaps that are published
  std::string description{"robot_description"};  ///< name of the parameter with the URDF
  double radius{0.0};                            ///< [m] of the robot; 0: as its description says
};

/// Reads all keys and does not call finish().
void read(config::ParameterReader& reader, NavigatorNodeConfig& config);

/// The robot's, by its radius or by its description.
/// @throws config::ConfigurationError where it is told neither
/// @throws std::runtime_error with one sentence where the description is bad
[[nodiscard]] navigation::Footprint footprintOf(const NavigatorNodeConfig& config,
                                                const ros::NodeHandle& nh);

}  // namespace omega_slam

#pragma once

#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/laser_scan.h"
#include "omega_slam/simulation/turtlebot.h"
#include "omega_slam/simulation/world_file.h"

namespace omega_slam::simulation {

/// One scan of a drive, with the odometry that belongs to it.
struct DriveScan {
  sensing::LaserScan scan;
  geometry::Pose2 T_odom_base;          ///< at the scan's stamp
  geometry::Pose2 motion_during_sweep;  ///< `T_start_end` of the base, first beam to last
};

/// What a recording of a drive along a world's route would hold, and the truth.
struct RouteDrive {
  std::vector<DriveScan> scans;
  geometry::Trajectory truth;  ///< `T_world_base` at each step of the physics
  int collisions{0};
  bool arrived{false};  ///< at the end of the route
};

/// Drives a TurtleBot along the route of a world, from its start, by RouteDriver's defaults.
/// @param seconds the drive is cut off after so much simulated time
/// @throws std::invalid_argument as TurtleBot
[[nodiscard]] RouteDrive driveRoute(const LoadedWorld& world, const TurtleBotConfig& config,
                                    double seconds = 900.0);

}  // namespace omega_slam::simulation

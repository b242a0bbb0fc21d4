#pragma once

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/sweep.h"

namespace omega_slam::test {

/// What a laser sees from inside of a room [-half_x, half_x] x [-half_y, half_y] [m] of the map:
/// beams all round, evenly spaced, without noise.
/// @param T_map_base pose of the robot, inside of the room
/// @param T_base_laser pose of the laser on the robot
[[nodiscard]] sensing::Sweep sweepInRoom(const Eigen::Vector2d& half,
                                         const geometry::Pose2& T_map_base,
                                         const geometry::Pose2& T_base_laser, int beams);

}  // namespace omega_slam::test

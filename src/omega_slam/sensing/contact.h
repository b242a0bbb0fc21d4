#pragma once

#include <Eigen/Core>
#include <vector>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::sensing {

/// What a round robot has bumped into, as points [m] in the map. A bumper says where it was
/// pressed, and not what by; whatever the laser did not see before, glass above all, is taken to be
/// as wide as the robot, across the direction of the contact.
/// @param contacts [m] in the base frame; those that are not finite or at its origin are left out
/// @param T_map_base where the robot was; @param radius [m] of the robot: nothing that it touches
/// lies nearer than this
[[nodiscard]] std::vector<Eigen::Vector2d> contactMarks(
    const std::vector<Eigen::Vector2d>& contacts, const geometry::Pose2& T_map_base, double radius);

}  // namespace omega_slam::sensing

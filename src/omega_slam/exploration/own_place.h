#pragma once

#include <Eigen/Core>

#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::exploration {

/// The map, with the floor below the robot free wherever the map knows nothing of it: a laser does
/// not see it, but the robot stands on it. Grown where the robot reaches over the edge.
/// @param position [m] of the robot in the map frame; @param radius [m] of the robot
[[nodiscard]] grid::OccupancyGrid withOwnPlaceFree(const grid::OccupancyGrid& map,
                                                   const Eigen::Vector2d& position, double radius);

}  // namespace omega_slam::exploration

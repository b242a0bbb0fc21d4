#pragma once

#include <random>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::test {

/// A closed hall of 12 m x 9 m with random walls and furniture, like no other; cells of 5 cm.
[[nodiscard]] grid::OccupancyGrid randomBuilding(std::mt19937_64& random);

/// The same map in another frame: every cell is looked up by its centre; unknown around.
[[nodiscard]] grid::OccupancyGrid seenFrom(const grid::OccupancyGrid& map,
                                           const geometry::Pose2& T_new_old);

}  // namespace omega_slam::test

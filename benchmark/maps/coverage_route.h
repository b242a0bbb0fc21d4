#pragma once

#include <vector>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::experiments {

struct CoverageConfig {
  double room{0.30};       ///< [m] from the robot's middle to the nearest obstacle
  double view_range{3.0};  ///< [m] a cell counts as seen from nearer
  double field_of_view{geometry::degreesToRadians(240.0)};  ///< [rad] of the laser
  double spacing{0.4};                                      ///< [m] between places to look from
  double least_gain{0.05};  ///< [m^2] for less that is new it goes nowhere
};

/// A drive on which all of a known building is seen.
struct CoverageRoute {
  Eigen::Vector2d start{0.0, 0.0};         ///< [m]
  std::vector<Eigen::Vector2d> waypoints;  ///< [m], back to the start in the end
  double seen{0.0};                        ///< share of the reachable open cells
};

/// Again and again goes to the place from which most is new for the way to it (as
/// Gonzalez-Banos and Latombe choose the next best view, IJRR 2002), until there is no more to see,
/// and then home. What is seen is counted along the way, in the direction of travel. Deterministic.
/// @param near [m] the drive begins at the place nearest to it where the robot fits
/// @throws std::runtime_error if it fits nowhere
[[nodiscard]] CoverageRoute planCoverage(const grid::OccupancyGrid& map,
                                         const Eigen::Vector2d& near,
                                         const CoverageConfig& config = {});

}  // namespace omega_slam::experiments

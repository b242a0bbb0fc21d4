#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "maps/coverage_route.h"
#include "omega_slam/evaluation/trajectory_error.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/sensing/sweep.h"
#include "omega_slam/simulation/route_drive.h"

namespace omega_slam::experiments {

/// A building to be mapped, and the way through it.
struct Site {
  std::string name;
  grid::OccupancyGrid truth;
  simulation::LoadedWorld world;  ///< its route leads past all that can be seen
  double seen_from_route{0.0};    ///< share of the reachable open cells
};

/// @param map_file of map_server @param near [m] where the drive begins, about
/// @throws std::runtime_error with one sentence if the map can't be read or the robot fits nowhere
[[nodiscard]] Site loadSite(const std::string& name, const std::filesystem::path& map_file,
                            const Eigen::Vector2d& near);

/// [s] of simulated time that a drive may take.
inline constexpr double kDrivePatience = 7200.0;

/// A sweep and where it is taken to be from.
struct PlacedSweep {
  sensing::Sweep sweep;
  geometry::Pose2 T_map_base;
};

/// What one drive through a site gives to draw maps from: the same keyframes three times.
struct Survey {
  std::vector<PlacedSweep> by_slam;        ///< noise on, poses by SLAM
  std::vector<PlacedSweep> by_truth;       ///< noise on, true poses
  std::vector<PlacedSweep> without_noise;  ///< a laser without error, true poses
  evaluation::TrajectoryError error;       ///< of SLAM
  double distance{0.0};                    ///< [m] driven
  double duration{0.0};                    ///< [s]
  std::size_t scans{0};
  std::size_t loops{0};
};

/// Drives through a site with the default TurtleBot, all its noise on, and maps it by the whole
/// SLAM pipeline with its defaults. True poses are given in the frame of the true map.
/// @throws std::runtime_error if the robot does not come to the end of its route
[[nodiscard]] Survey survey(const Site& site, std::uint64_t seed);

}  // namespace omega_slam::experiments

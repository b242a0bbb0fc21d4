#pragma once

#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/simulation/world.h"

namespace omega_slam::experiments {

/// [m] Centres of the cells that the middle of a round robot can get to in a world.
/// @param start [m] of the robot in the world; @param radius [m] of the robot
[[nodiscard]] std::vector<Eigen::Vector2d> standingRoom(const simulation::World& world,
                                                        const Eigen::Vector2d& start,
                                                        double radius);

/// The cells of a world that a round robot with a laser can see from where it can get to: what an
/// exploration is measured by.
class Seeable {
 public:
  /// @param start [m] of the robot in the world; @param radius [m] of the robot
  /// @param range [m] of the laser; beams that meet nothing within it see open space as far as
  /// sensing::ScanIntakeConfig has it
  Seeable(const simulation::World& world, const Eigen::Vector2d& start, double radius,
          double range);

  /// [m] centres of the cells, in the world.
  [[nodiscard]] const std::vector<Eigen::Vector2d>& cells() const { return cells_; }
  [[nodiscard]] double area() const;  ///< [m^2]

  /// Share of the cells that a map knows, in it or right beside: maps may be off by a cell.
  /// @param T_world_map where the map lies in the world
  [[nodiscard]] double knownShare(const grid::OccupancyGrid& map,
                                  const geometry::Pose2& T_world_map) const;

 private:
  double cell_area_;  ///< [m^2]
  std::vector<Eigen::Vector2d> cells_;
};

}  // namespace omega_slam::experiments

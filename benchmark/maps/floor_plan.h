#pragma once

#include <optional>
#include <vector>

#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::experiments {

/// The known map of a building as a robot that is to drive through it looks at it.
class FloorPlan {
 public:
  /// @param room [m] from the robot's middle to whatever is not known to be open
  FloorPlan(grid::OccupancyGrid map, double room);

  [[nodiscard]] const grid::GridGeometry& geometry() const { return map_.geometry; }

  /// [m] from the centre of a cell to the nearest one that is not open, edge to edge; 0 outside.
  [[nodiscard]] double clearance(const grid::Cell& cell) const;
  [[nodiscard]] bool fits(const grid::Cell& cell) const { return clearance(cell) >= room_; }

  /// The cell nearest to a point [m] at which the robot fits.
  /// @throws std::runtime_error if it fits nowhere
  [[nodiscard]] grid::Cell nearestFit(const Eigen::Vector2d& point) const;

  /// The smallest clearance [m] on the straight line between two cells.
  [[nodiscard]] double clearanceAlong(const grid::Cell& from, const grid::Cell& to) const;

  /// Indices of the open cells that are in sight from a cell: up to `range` [m], within
  /// `half_angle` [rad] of `heading` [rad] in the map. Sorted, each once.
  [[nodiscard]] std::vector<std::size_t> visibleFrom(const grid::Cell& cell, double range,
                                                     double heading, double half_angle) const;

 private:
  grid::OccupancyGrid map_;
  double room_;
  std::vector<float> clearance_;
};

/// Shortest ways from one cell to all others, where room is worth a detour (Dijkstra 1959).
class Ways {
 public:
  Ways(const FloorPlan& plan, const grid::Cell& from);

  /// [m], with narrow places dearer; none if there is no way
  [[nodiscard]] std::optional<double> cost(const grid::Cell& to) const;

  /// Cells from the origin to one that there is a way to, both included.
  [[nodiscard]] std::vector<grid::Cell> path(const grid::Cell& to) const;

 private:
  const FloorPlan& plan_;
  std::vector<double> costs_;
  std::vector<std::size_t> parents_;
};

}  // namespace omega_slam::experiments

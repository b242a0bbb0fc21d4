#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::evaluation {

/// Cells count as walls from 65 up and as open from 0 to 25, as map_saver has it; all others are
/// unknown.
[[nodiscard]] inline bool isWall(std::int8_t value) { return value >= 65; }
[[nodiscard]] inline bool isOpen(std::int8_t value) { return value >= 0 && value <= 25; }

/// One yes or no for each cell of a grid; outside of it the answer is no.
class CellMask {
 public:
  explicit CellMask(const grid::GridGeometry& geometry)
      : geometry_(geometry), flags_(geometry.size(), 0) {}

  /// Cells outside are ignored.
  void set(const grid::Cell& cell);
  [[nodiscard]] bool at(const grid::Cell& cell) const {
    return geometry_.contains(cell) && flags_[geometry_.index(cell)] != 0;
  }
  /// @param point [m] in the grid's frame, as far away as may be
  [[nodiscard]] bool at(const Eigen::Vector2d& point) const;
  /// Whether a cell or one of the eight around it is set.
  [[nodiscard]] bool touches(const grid::Cell& cell) const;

 private:
  grid::GridGeometry geometry_;
  std::vector<std::uint8_t> flags_;
};

/// Calls visit(Cell) for each cell of a grid, row by row.
template <typename Visitor>
void forEachCell(const grid::GridGeometry& geometry, Visitor&& visit) {
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      visit(grid::Cell(x, y));
    }
  }
}

[[nodiscard]] CellMask openCells(const grid::OccupancyGrid& map);

/// Walls, and what lies within `reach` cells of one along both axes, also beyond the edge of the
/// map: the mask's grid is so many cells larger on every side.
[[nodiscard]] CellMask wallsWidened(const grid::OccupancyGrid& map, int reach);

/// Open cells that are connected with the one at `start` [m] by edges of cells; none if that is not
/// open.
[[nodiscard]] CellMask reachableFrom(const grid::OccupancyGrid& map, const Eigen::Vector2d& start);

/// The largest set of open cells that are connected by edges; of equals, the lowest.
[[nodiscard]] CellMask largestOpenSpace(const grid::OccupancyGrid& map);

}  // namespace omega_slam::evaluation

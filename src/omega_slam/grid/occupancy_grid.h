#pragma once

#include <cstdint>
#include <vector>

#include "omega_slam/grid/grid_geometry.h"

namespace omega_slam::grid {

inline constexpr std::int8_t kUnknown = -1;
inline constexpr std::int8_t kFree = 0;
inline constexpr std::int8_t kOccupied = 100;

/// A map as nav_msgs/OccupancyGrid has it: -1 unknown, 0..100 probability of an obstacle in
/// percent. `cells` is row-major, row 0 at the bottom (smallest y).
struct OccupancyGrid {
  GridGeometry geometry;
  std::vector<std::int8_t> cells;

  [[nodiscard]] std::int8_t at(const Cell& cell) const { return cells[geometry.index(cell)]; }
  [[nodiscard]] std::int8_t& at(const Cell& cell) { return cells[geometry.index(cell)]; }
};

/// A grid of one value everywhere.
[[nodiscard]] inline OccupancyGrid makeGrid(const GridGeometry& geometry, std::int8_t value) {
  return {geometry, std::vector<std::int8_t>(geometry.size(), value)};
}

}  // namespace omega_slam::grid

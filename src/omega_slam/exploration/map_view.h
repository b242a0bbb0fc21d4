#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::exploration {

/// Cells here are numbered from the origin of the map frame and not from the corner of the image,
/// so that a cell keeps its number while the map grows.
using grid::Cell;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    const auto x = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.x()));
    const auto y = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.y()));
    return static_cast<std::size_t>((x << 32U | y) * 0x9E3779B97F4A7C15ULL >> 7U);
  }
};
using CellSet = std::unordered_set<Cell, CellHash>;
template <class T>
using CellMap = std::unordered_map<Cell, T, CellHash>;

enum class CellState : std::uint8_t { kUnknown, kFree, kOccupied };

/// Percentages of maps that are not strictly {-1, 0, 100}, as map_saver divides them: up to the
/// first a cell is free, from the second on occupied, and unknown between.
inline constexpr std::int8_t kFreeLimit = 25;
inline constexpr std::int8_t kOccupiedLimit = 65;

[[nodiscard]] inline CellState stateOf(std::int8_t value) {
  if (value >= kOccupiedLimit) {
    return CellState::kOccupied;
  }
  return value >= 0 && value <= kFreeLimit ? CellState::kFree : CellState::kUnknown;
}

/// The four cells that share an edge with a cell, then the four that share a corner.
inline const std::array<Cell, 8> kNeighbours{Cell{1, 0}, Cell{0, 1},  Cell{-1, 0},  Cell{0, -1},
                                             Cell{1, 1}, Cell{-1, 1}, Cell{-1, -1}, Cell{1, -1}};
inline constexpr std::size_t kEdgeNeighbours = 4;

/// A map as exploration sees it: three states, unknown wherever there is no map, cells numbered
/// from the origin of the map frame. Looks at the map, which must outlive it.
class MapView {
 public:
  explicit MapView(const grid::OccupancyGrid& map)
      : map_(&map),
        corner_(static_cast<int>(std::lround(map.geometry.origin.x() / map.geometry.resolution)),
                static_cast<int>(std::lround(map.geometry.origin.y() / map.geometry.resolution))) {}

  [[nodiscard]] CellState at(const Cell& cell) const {
    const Cell local = cell - corner_;
    return map_->geometry.contains(local) ? stateOf(map_->at(local)) : CellState::kUnknown;
  }
  [[nodiscard]] bool isFree(const Cell& cell) const { return at(cell) == CellState::kFree; }

  /// The paper's definition: unknown, and right next to open space.
  [[nodiscard]] bool isFrontier(const Cell& cell) const {
    if (at(cell) != CellState::kUnknown) {
      return false;
    }
    for (std::size_t i = 0; i < kEdgeNeighbours; ++i) {
      if (isFree(cell + kNeighbours[i])) {
        return true;
      }
    }
    return false;
  }

  /// [m] in the map frame, and back.
  [[nodiscard]] Cell cellAt(const Eigen::Vector2d& point) const {
    return map_->geometry.cellAt(point) + corner_;
  }
  [[nodiscard]] Eigen::Vector2d center(const Cell& cell) const {
    return map_->geometry.center(cell - corner_);
  }
  [[nodiscard]] const grid::GridGeometry& geometry() const { return map_->geometry; }
  [[nodiscard]] const grid::OccupancyGrid& map() const { return *map_; }
  [[nodiscard]] const Cell& corner() const { return corner_; }  ///< number of the map's cell (0, 0)

  /// Whether cells of the two maps that bear the same number lie in the same place.
  [[nodiscard]] bool sharesCellsWith(const MapView& other) const {
    return geometry().resolution == other.geometry().resolution &&
           (center({0, 0}) - other.center({0, 0})).norm() < 0.01 * geometry().resolution;
  }

 private:
  const grid::OccupancyGrid* map_;
  Cell corner_;
};

}  // namespace omega_slam::exploration

#include "omega_slam/exploration/own_place.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/exploration/map_view.h"

namespace omega_slam::exploration {
namespace {

/// With room for the cells from `low` to `high`, numbered as those of the map.
grid::OccupancyGrid grown(const grid::OccupancyGrid& map, const Cell& low, const Cell& high) {
  const grid::GridGeometry& old = map.geometry;
  const Cell first = low.cwiseMin(0);
  const Cell last = high.cwiseMax(Cell(old.width - 1, old.height - 1));
  grid::GridGeometry geometry = old;
  geometry.origin += old.resolution * first.cast<double>();
  geometry.width = last.x() - first.x() + 1;
  geometry.height = last.y() - first.y() + 1;
  grid::OccupancyGrid result = grid::makeGrid(geometry, grid::kUnknown);
  for (int row = 0; row < old.height; ++row) {
    const auto from = map.cells.begin() + static_cast<std::ptrdiff_t>(old.index({0, row}));
    const Cell to = Cell(0, row) - first;
    std::copy(from, from + old.width,
              result.cells.begin() + static_cast<std::ptrdiff_t>(geometry.index(to)));
  }
  return result;
}

}  // namespace

grid::OccupancyGrid withOwnPlaceFree(const grid::OccupancyGrid& map,
                                     const Eigen::Vector2d& position, double radius) {
  const int reach = static_cast<int>(std::ceil(radius / map.geometry.resolution)) + 1;
  const Cell disc(reach, reach);
  const Cell before = map.geometry.cellAt(position);
  grid::OccupancyGrid result = grown(map, before - disc, before + disc);
  const Cell here = result.geometry.cellAt(position);
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const Cell cell = here + Cell(x, y);
      if (x * x + y * y <= reach * reach && result.geometry.contains(cell) &&
          stateOf(result.at(cell)) == CellState::kUnknown) {
        result.at(cell) = grid::kFree;
      }
    }
  }
  return result;
}

}  // namespace omega_slam::exploration

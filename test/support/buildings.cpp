#include "support/buildings.h"

#include <cmath>

namespace omega_slam::test {
namespace {

using grid::Cell;

void fill(const Cell& corner, const Cell& size, grid::OccupancyGrid& map) {
  for (int y = corner.y(); y < corner.y() + size.y(); ++y) {
    for (int x = corner.x(); x < corner.x() + size.x(); ++x) {
      if (map.geometry.contains({x, y})) {
        map.at({x, y}) = grid::kOccupied;
      }
    }
  }
}

}  // namespace

grid::OccupancyGrid randomBuilding(std::mt19937_64& random) {
  constexpr int kWidth = 240;
  constexpr int kHeight = 180;
  grid::OccupancyGrid map = grid::makeGrid({0.05, {-2.0, 1.0}, kWidth, kHeight}, grid::kFree);
  fill({0, 0}, {kWidth, 2}, map);
  fill({0, kHeight - 2}, {kWidth, 2}, map);
  fill({0, 0}, {2, kHeight}, map);
  fill({kWidth - 2, 0}, {2, kHeight}, map);
  std::uniform_int_distribution<int> x(0, kWidth - 1);
  std::uniform_int_distribution<int> y(0, kHeight - 1);
  std::uniform_int_distribution<int> length(20, 60);
  std::uniform_int_distribution<int> edge(3, 14);
  for (int k = 0; k < 4; ++k) {
    fill({x(random), y(random)}, {length(random), 2}, map);
    fill({x(random), y(random)}, {2, length(random)}, map);
  }
  for (int k = 0; k < 25; ++k) {
    fill({x(random), y(random)}, {edge(random), edge(random)}, map);
  }
  return map;
}

grid::OccupancyGrid seenFrom(const grid::OccupancyGrid& map, const geometry::Pose2& T_new_old) {
  const grid::GridGeometry& old = map.geometry;
  const Eigen::Vector2d size = old.resolution * Eigen::Vector2d(old.width, old.height);
  const double reach = 0.5 * size.norm();
  const Eigen::Vector2d middle = T_new_old * Eigen::Vector2d(old.origin + 0.5 * size);
  const int cells = static_cast<int>(std::ceil(2.0 * reach / old.resolution));
  grid::OccupancyGrid seen = grid::makeGrid(
      {old.resolution, middle - Eigen::Vector2d(reach, reach), cells, cells}, grid::kUnknown);
  const geometry::Pose2 T_old_new = T_new_old.inverse();
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const Cell cell = old.cellAt(T_old_new * seen.geometry.center({column, row}));
      if (old.contains(cell)) {
        seen.at({column, row}) = map.at(cell);
      }
    }
  }
  return seen;
}

}  // namespace omega_slam::test

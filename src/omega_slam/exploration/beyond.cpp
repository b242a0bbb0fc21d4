#include "omega_slam/exploration/beyond.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::exploration {
namespace {

constexpr double kCorner = 0.1;  // [m] more than the radius, lest corners of rooms count

}  // namespace

Beyond::Beyond(const MapView& map, const TravelField& travel, double radius)
    : map_(map), come_to_(map.map().cells.size(), 0) {
  const grid::GridGeometry& geometry = map.geometry();
  const std::vector<Cell> disc = discAround((radius + kCorner) / geometry.resolution);
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      const Cell here = Cell(x, y) + map.corner();
      if (!travel.distanceTo(here)) {
        continue;
      }
      come_to_[geometry.index({x, y})] = 1;
      const bool is_inside =
          std::all_of(kNeighbours.begin(), kNeighbours.end(),
                      [&](const Cell& step) { return travel.distanceTo(here + step); });
      for (std::size_t i = 0; i < disc.size() && !is_inside; ++i) {
        if (const Cell near = Cell(x, y) + disc[i]; geometry.contains(near)) {
          come_to_[geometry.index(near)] = 1;
        }
      }
    }
  }
}

bool Beyond::contains(const Cell& cell) const {
  const CellState state = map_.at(cell);
  return state == CellState::kUnknown ||
         (state == CellState::kFree && come_to_[map_.geometry().index(cell - map_.corner())] == 0);
}

double Beyond::areaBehind(const Frontier& frontier, double reach) const {
  const double resolution = map_.geometry().resolution;
  const int cells = static_cast<int>(std::floor(reach / resolution));
  const int edge = 2 * cells + 1;
  const Cell middle = map_.cellAt(frontier.centroid);
  std::vector<bool> met(static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge));
  std::vector<Cell> queue;
  const auto meet = [&](const Cell& cell) {
    const Cell step = cell - middle;
    if (step.squaredNorm() > cells * cells || !contains(cell)) {
      return;
    }
    const auto index = static_cast<std::size_t>((step.y() + cells) * edge + step.x() + cells);
    if (!met[index]) {
      met[index] = true;
      queue.push_back(cell);
    }
  };
  std::for_each(frontier.cells.begin(), frontier.cells.end(), meet);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Cell here = queue[i];
    for (std::size_t k = 0; k < kEdgeNeighbours; ++k) {
      meet(here + kNeighbours[k]);
    }
  }
  return static_cast<double>(queue.size()) * resolution * resolution;
}

}  // namespace omega_slam::exploration

#include "omega_slam/exploration/wavefront_detector.h"

#include <cmath>

namespace omega_slam::exploration {
namespace {

/// Which cells the search has met: those of the map, and the rim of cells around it.
class Visited {
 public:
  explicit Visited(const MapView& map)
      : corner_(map.corner() - Cell(1, 1)),
        width_(map.geometry().width + 2),
        met_(static_cast<std::size_t>(width_) *
             static_cast<std::size_t>(map.geometry().height + 2)) {}

  /// @return whether it is the first time
  bool meet(const Cell& cell) {
    const Cell local = cell - corner_;
    const auto index = static_cast<std::size_t>(local.y()) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(local.x());
    const bool first = !met_[index];
    met_[index] = true;
    return first;
  }

 private:
  Cell corner_;
  int width_;
  std::vector<bool> met_;
};

std::vector<Cell> openCellsAround(const MapView& map, const Eigen::Vector2d& start, double reach) {
  const Cell center = map.cellAt(start);
  const int radius = static_cast<int>(std::ceil(reach / map.geometry().resolution));
  std::vector<Cell> open;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      const Cell cell = center + Cell(x, y);
      if (x * x + y * y <= radius * radius && map.isFree(cell)) {
        open.push_back(cell);
      }
    }
  }
  return open;
}

}  // namespace

std::vector<Frontier> detectByWavefront(const MapView& map, const Eigen::Vector2d& start,
                                        double reach) {
  Visited visited(map);
  std::vector<Cell> open = openCellsAround(map, start, reach);
  for (const Cell& cell : open) {
    visited.meet(cell);
  }
  std::vector<Cell> frontier_cells;
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (std::size_t k = 0; k < kEdgeNeighbours; ++k) {
      const Cell next = open[i] + kNeighbours[k];
      const CellState state = map.at(next);
      if (state == CellState::kOccupied || !visited.meet(next)) {
        continue;
      }
      (state == CellState::kFree ? open : frontier_cells).push_back(next);
    }
  }
  return clusterFrontiers(std::move(frontier_cells), map);
}

}  // namespace omega_slam::exploration

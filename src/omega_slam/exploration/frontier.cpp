#include "omega_slam/exploration/frontier.h"

#include <algorithm>

namespace omega_slam::exploration {
namespace {

/// Takes what is connected with `first` out of `rest`.
std::vector<Cell> takeConnected(const Cell& first, CellSet& rest) {
  std::vector<Cell> cells{first};
  rest.erase(first);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const Cell& step : kNeighbours) {
      const Cell next = cells[i] + step;
      if (rest.erase(next) > 0) {
        cells.push_back(next);
      }
    }
  }
  std::sort(cells.begin(), cells.end(), comesBefore);
  return cells;
}

/// The mean of a bent frontier may lie anywhere, so the cell nearest to it stands for the whole.
Eigen::Vector2d centroidOn(const std::vector<Cell>& cells, const MapView& map) {
  Eigen::Vector2d sum(0.0, 0.0);
  for (const Cell& cell : cells) {
    sum += cell.cast<double>();
  }
  const Eigen::Vector2d mean = sum / static_cast<double>(cells.size());
  const auto nearest =
      std::min_element(cells.begin(), cells.end(), [&mean](const Cell& a, const Cell& b) {
        return (a.cast<double>() - mean).squaredNorm() < (b.cast<double>() - mean).squaredNorm();
      });
  return map.center(*nearest);
}

}  // namespace

std::vector<Frontier> clusterFrontiers(std::vector<Cell> cells, const MapView& map) {
  std::sort(cells.begin(), cells.end(), comesBefore);
  CellSet rest(cells.begin(), cells.end());
  std::vector<Frontier> frontiers;
  for (const Cell& cell : cells) {
    if (rest.count(cell) == 0) {
      continue;
    }
    Frontier frontier;
    frontier.cells = takeConnected(cell, rest);
    frontier.centroid = centroidOn(frontier.cells, map);
    for (const Cell& member : frontier.cells) {
      frontier.box.extend(member);
    }
    frontier.size = static_cast<double>(frontier.cells.size()) * map.geometry().resolution;
    frontiers.push_back(std::move(frontier));
  }
  return frontiers;
}

}  // namespace omega_slam::exploration

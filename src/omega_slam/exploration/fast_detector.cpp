#include "omega_slam/exploration/fast_detector.h"

#include <set>

namespace omega_slam::exploration {
namespace {

/// Frontiers that may reach into the box.
std::vector<FrontierId> frontiersIn(const FrontierStore& store, const Eigen::AlignedBox2i& box) {
  std::vector<FrontierId> inside;
  for (const auto& [id, frontier] : store.all()) {
    if (box.intersects(frontier.box)) {
      inside.push_back(id);
    }
  }
  return inside;
}

}  // namespace

void FastDetector::update(const MapView& map, const Contour& contour) {
  if (contour.cells.empty()) {
    return;
  }
  std::set<FrontierId> touched;
  std::vector<Cell> added;
  for (const Cell& cell : contour.cells) {
    if (store_.ownerOf(cell) != 0 || !map.isFrontier(cell)) {
      continue;
    }
    added.push_back(cell);
    for (const Cell& step : kNeighbours) {
      if (const FrontierId owner = store_.ownerOf(cell + step); owner != 0) {
        touched.insert(owner);
      }
    }
  }
  for (const FrontierId id : frontiersIn(store_, contour.touched)) {
    touched.insert(id);
  }
  for (const FrontierId id : touched) {
    for (const Cell& cell : store_.all().at(id).cells) {
      if (map.isFrontier(cell)) {
        added.push_back(cell);
      }
    }
  }
  store_.replace({touched.begin(), touched.end()}, clusterFrontiers(std::move(added), map));
}

void FastDetector::searchAll(const MapView& map) {
  store_.replaceAll(clusterFrontiers(allFrontierCells(map), map));
}

std::vector<Cell> allFrontierCells(const MapView& map) {
  std::vector<Cell> cells;
  const Cell size(map.geometry().width, map.geometry().height);
  for (int row = -1; row <= size.y(); ++row) {  // the rim beyond the edge counts
    for (int col = -1; col <= size.x(); ++col) {
      const Cell cell = map.corner() + Cell(col, row);
      if (map.isFrontier(cell)) {
        cells.push_back(cell);
      }
    }
  }
  return cells;
}

}  // namespace omega_slam::exploration

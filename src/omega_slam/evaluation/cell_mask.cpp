#include "omega_slam/evaluation/cell_mask.h"

#include <array>
#include <cstddef>

namespace omega_slam::evaluation {
namespace {

using grid::Cell;
using grid::OccupancyGrid;

/// Sets what is connected with `start` in `reached`. @return how many cells that are
std::size_t flood(const CellMask& open, const Cell& start, CellMask& reached) {
  std::vector<Cell> pending{start};
  reached.set(start);
  std::size_t count = 1;
  const std::array<Cell, 4> steps{Cell(1, 0), Cell(0, 1), Cell(-1, 0), Cell(0, -1)};
  while (!pending.empty()) {
    const Cell cell = pending.back();
    pending.pop_back();
    for (const Cell& step : steps) {
      if (const Cell next = cell + step; open.at(next) && !reached.at(next)) {
        reached.set(next);
        pending.push_back(next);
        ++count;
      }
    }
  }
  return count;
}

}  // namespace

void CellMask::set(const Cell& cell) {
  if (geometry_.contains(cell)) {
    flags_[geometry_.index(cell)] = 1;
  }
}

bool CellMask::at(const Eigen::Vector2d& point) const {
  // Points far outside would not fit into a cell's numbers.
  const Eigen::Array2d cells = (point - geometry_.origin).array() / geometry_.resolution;
  const bool inside =
      (cells >= 0.0).all() && cells.x() < geometry_.width && cells.y() < geometry_.height;
  return inside && at(Cell(cells.floor().cast<int>()));
}

bool CellMask::touches(const Cell& cell) const {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (at(Cell(cell + Cell(dx, dy)))) {
        return true;
      }
    }
  }
  return false;
}

CellMask openCells(const OccupancyGrid& map) {
  CellMask open(map.geometry);
  forEachCell(map.geometry, [&](const Cell& cell) {
    if (isOpen(map.at(cell))) {
      open.set(cell);
    }
  });
  return open;
}

CellMask wallsWidened(const OccupancyGrid& map, int reach) {
  grid::GridGeometry grown = map.geometry;
  grown.origin.array() -= reach * grown.resolution;
  grown.width += 2 * reach;
  grown.height += 2 * reach;
  CellMask mask(grown);
  forEachCell(map.geometry, [&](const Cell& cell) {
    if (!isWall(map.at(cell))) {
      return;
    }
    for (int dy = 0; dy <= 2 * reach; ++dy) {
      for (int dx = 0; dx <= 2 * reach; ++dx) {
        mask.set(cell + Cell(dx, dy));
      }
    }
  });
  return mask;
}

CellMask reachableFrom(const OccupancyGrid& map, const Eigen::Vector2d& start) {
  const CellMask open = openCells(map);
  CellMask reached(map.geometry);
  if (open.at(start)) {
    flood(open, map.geometry.cellAt(start), reached);
  }
  return reached;
}

CellMask largestOpenSpace(const OccupancyGrid& map) {
  const CellMask open = openCells(map);
  CellMask seen(map.geometry);
  Cell inside(0, 0);
  std::size_t most = 0;
  forEachCell(map.geometry, [&](const Cell& cell) {
    if (!open.at(cell) || seen.at(cell)) {
      return;
    }
    if (const std::size_t count = flood(open, cell, seen); count > most) {
      most = count;
      inside = cell;
    }
  });
  CellMask largest(map.geometry);
  if (most > 0) {
    flood(open, inside, largest);
  }
  return largest;
}

}  // namespace omega_slam::evaluation

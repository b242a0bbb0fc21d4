#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstring>

#include "omega_slam/grid/grid_geometry.h"
#include "omega_slam/matching/zeroed_cells.h"

namespace omega_slam::matching {

/// Some cells of a grid, from one corner to the other, both included.
using CellBox = Eigen::AlignedBox2i;

/// The same place in a grid that has `split` cells, along each axis, for one.
[[nodiscard]] inline CellBox splitCells(const CellBox& box, int split) {
  return box.isEmpty() ? box : CellBox(box.min() * split, (box.max().array() + 1) * split - 1);
}

/// Calls `visit(first cell, number of cells)` for each row of a box.
template <class Visitor>
void forEachRow(const CellBox& box, const Visitor& visit) {
  if (box.isEmpty()) {
    return;
  }
  const auto count = static_cast<std::size_t>(box.max().x() - box.min().x() + 1);
  for (int row = box.min().y(); row <= box.max().y(); ++row) {
    visit(grid::Cell(box.min().x(), row), count);
  }
}

/// Cells for another grid, zero but for a box of this one's.
/// @param shift from a cell to that of the other grid at the same place
template <typename CellType>
[[nodiscard]] ZeroedCells<CellType> movedCells(const CellBox& box, const grid::GridGeometry& from,
                                               const ZeroedCells<CellType>& cells,
                                               const grid::GridGeometry& to,
                                               const grid::Cell& shift) {
  ZeroedCells<CellType> moved(to.size());
  forEachRow(box, [&](const grid::Cell& first, std::size_t count) {
    std::memcpy(&moved[to.index(first + shift)], &cells[from.index(first)],
                count * sizeof(CellType));
  });
  return moved;
}

/// Puts a box of cells back to zero.
template <typename CellType>
void zeroCells(const CellBox& box, const grid::GridGeometry& geometry,
               ZeroedCells<CellType>& cells) {
  forEachRow(box, [&](const grid::Cell& first, std::size_t count) {
    std::memset(&cells[geometry.index(first)], 0, count * sizeof(CellType));
  });
}

}  // namespace omega_slam::matching

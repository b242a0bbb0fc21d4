#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "omega_slam/grid/grid_geometry.h"
#include "omega_slam/matching/window_cells.h"
#include "omega_slam/matching/zeroed_cells.h"

namespace omega_slam::matching {

/// Cells of a grid, stored block by block: a line through the grid, whichever way it goes, meets
/// few cache lines and pages. (Beams upwards took three times as long as sideways, row by row.)
///
/// Where a cell is stored is the sum of what its column and what its row say.
template <typename CellType>
class BlockedCells {
 public:
  BlockedCells() = default;

  /// @param size  blocks along each axis
  /// @param shift a block has 2^shift cells on each side
  BlockedCells(const grid::Cell& size, int shift)
      : shift_(shift),
        columns_(static_cast<std::size_t>(size.x()) << shift),
        rows_(static_cast<std::size_t>(size.y()) << shift),
        cells_(columns_.size() * rows_.size()) {
    const std::size_t mask = (std::size_t{1} << shift) - 1;
    for (std::size_t x = 0; x < columns_.size(); ++x) {
      columns_[x] = static_cast<std::uint32_t>(((x >> shift) << (2 * shift)) + (x & mask));
    }
    for (std::size_t y = 0; y < rows_.size(); ++y) {
      const std::size_t blocks = (y >> shift) * static_cast<std::size_t>(size.x());
      rows_[y] = static_cast<std::uint32_t>((blocks << (2 * shift)) + ((y & mask) << shift));
    }
  }

  [[nodiscard]] CellType& operator()(const grid::Cell& cell) { return cells_[indexOf(cell)]; }
  [[nodiscard]] const CellType& operator()(const grid::Cell& cell) const {
    return cells_[indexOf(cell)];
  }

  /// All cells, for a loop that goes along one axis: what is stored where, by the indices along
  /// that axis and across it.
  struct Along {
    const std::uint32_t* along;
    const std::uint32_t* across;
    CellType* cells;

    [[nodiscard]] CellType& at(std::int64_t index_along, std::int64_t index_across) const {
      return cells[along[index_along] + across[index_across]];
    }
  };
  /// @param axis 0 for x, 1 for y
  [[nodiscard]] Along along(int axis) {
    return axis == 0 ? Along{columns_.data(), rows_.data(), cells_.begin()}
                     : Along{rows_.data(), columns_.data(), cells_.begin()};
  }

  /// The same cells, as far as they are in a box of blocks, in a grid of another size; zero
  /// elsewhere.
  /// @param way from a block to that of the other grid at the same place
  [[nodiscard]] BlockedCells moved(const CellBox& blocks, const grid::Cell& size,
                                   const grid::Cell& way, int shift) const {
    BlockedCells other(size, shift);
    forEachRow(blocks, [&](const grid::Cell& first, std::size_t count) {
      std::memcpy(other.block(first + way), block(first), bytesOf(count));
    });
    return other;
  }

  /// Calls `visit(first cell, number of cells)` for stretches of all cells in a box of blocks.
  template <class Visitor>
  void forEachStretch(const CellBox& blocks, const Visitor& visit) {
    forEachRow(blocks, [&](const grid::Cell& first, std::size_t count) {
      visit(block(first), count << (2 * shift_));
    });
  }

 private:
  [[nodiscard]] std::size_t bytesOf(std::size_t blocks) const {
    return (blocks << (2 * shift_)) * sizeof(CellType);
  }
  [[nodiscard]] std::size_t indexOf(const grid::Cell& cell) const {
    return columns_[static_cast<std::size_t>(cell.x())] + rows_[static_cast<std::size_t>(cell.y())];
  }
  /// The first cell of a block; its others follow.
  [[nodiscard]] CellType* block(const grid::Cell& block) {
    return &(*this)(grid::Cell(block.x() << shift_, block.y() << shift_));
  }
  [[nodiscard]] const CellType* block(const grid::Cell& block) const {
    return &(*this)(grid::Cell(block.x() << shift_, block.y() << shift_));
  }

  int shift_{0};
  std::vector<std::uint32_t> columns_;
  std::vector<std::uint32_t> rows_;
  ZeroedCells<CellType> cells_;
};

}  // namespace omega_slam::matching

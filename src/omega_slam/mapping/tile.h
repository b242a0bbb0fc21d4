#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>

#include "omega_slam/grid/grid_geometry.h"

namespace omega_slam::mapping {

/// Maps are kept in square tiles of so many cells a side: as many as a word has bits, so that a row
/// of a tile is a word, and sets of cells are joined, cut and counted a row at a time.
inline constexpr int kTileSide = 64;
inline constexpr std::size_t kTileCells = std::size_t{kTileSide} * kTileSide;

/// A tile by column and row. Tile (0, 0) begins at cell (0, 0), the origin of the map frame.
using TileIndex = Eigen::Vector2i;

/// Cells, or tiles, of a rectangle; both corners are inclusive.
using CellBox = Eigen::AlignedBox<int, 2>;

/// Some of a tile's cells: bit x of word y is cell (x, y) of the tile.
using TileBits = std::array<std::uint64_t, kTileSide>;

[[nodiscard]] inline TileIndex tileOf(const grid::Cell& cell) {
  return {cell.x() >> 6, cell.y() >> 6};  // floors, for negative cells too
}

/// Calls `visit(x)` for every bit that is set in a row, from the lowest on.
template <class Visitor>
void forEachBit(std::uint64_t row, const Visitor& visit) {
  for (; row != 0; row &= row - 1) {
    visit(static_cast<std::size_t>(__builtin_ctzll(row)));
  }
}

/// The first cell of a tile.
[[nodiscard]] inline grid::Cell cornerOf(const TileIndex& tile) { return tile * kTileSide; }

/// A cell counted from the first one of its tile: 0 .. kTileSide - 1.
[[nodiscard]] inline grid::Cell withinTile(const grid::Cell& cell) {
  return {cell.x() & (kTileSide - 1), cell.y() & (kTileSide - 1)};
}

/// The tiles that hold the cells of a box.
[[nodiscard]] inline CellBox tilesOf(const CellBox& cells) {
  return cells.isEmpty() ? CellBox() : CellBox(tileOf(cells.min()), tileOf(cells.max()));
}

/// The cell that a point in cells falls into.
[[nodiscard]] inline grid::Cell cellOf(const Eigen::Vector2d& point) {
  return point.array().floor().cast<int>();
}

}  // namespace omega_slam::mapping

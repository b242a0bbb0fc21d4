#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "omega_slam/grid/grid_geometry.h"

namespace omega_slam::matching {

/// A grid of which only the parts near something are kept. Surfaces are lines in the plane: most of
/// a fine grid around them would be empty. A tile of kSide x kSide cells exists once one of its
/// cells is to be written; elsewhere all cells are `Value{}`.
template <class Value>
class TiledGrid {
 public:
  static constexpr int kSide = 32;

  TiledGrid() = default;

  /// Covers the cells from `min` to `max`, both included.
  TiledGrid(const grid::Cell& min, const grid::Cell& max)
      : origin_(min),
        columns_(static_cast<unsigned>(max.x() - min.x()) / kSide + 1),
        rows_(static_cast<unsigned>(max.y() - min.y()) / kSide + 1),
        tiles_(static_cast<std::size_t>(columns_) * rows_, kEmptyTile),
        values_(kCells) {}

  /// Any cell, also one that the grid does not cover.
  [[nodiscard]] Value at(int x, int y) const {
    const Place place = placeOf(x, y);
    if (place.column / kSide >= columns_ || place.row / kSide >= rows_) {
      return Value{};
    }
    return values_[tiles_[tileOf(place)] + cellOf(place)];
  }

  /// Four cells, `step` > 0 apart: (x, y), (x + step, y), (x, y + step), (x + step, y + step).
  [[nodiscard]] std::array<Value, 4> atFour(int x, int y, int step) const {
    const Place place = placeOf(x, y);
    const unsigned last = kSide - static_cast<unsigned>(step);
    if (place.column % kSide >= last || place.row % kSide >= last ||
        place.column / kSide >= columns_ || place.row / kSide >= rows_) {
      return {at(x, y), at(x + step, y), at(x, y + step), at(x + step, y + step)};
    }
    const Value* const low = &values_[tiles_[tileOf(place)] + cellOf(place)];
    const Value* const high = low + step * kSide;
    return {low[0], low[step], high[0], high[step]};
  }

  /// A cell to be written, which the grid must cover.
  [[nodiscard]] Value& operator()(int x, int y) { return writable(placeOf(x, y)); }

  /// Cells of a row to be written, which the grid must cover, in contiguous pieces: calls
  /// `visit(x of the first cell, pointer to it, number of cells)` for each.
  template <class Visitor>
  void visitRow(int first_x, int last_x, int y, const Visitor& visit) {
    for (int x = first_x; x <= last_x;) {
      const Place place = placeOf(x, y);
      const int rest_of_tile = kSide - static_cast<int>(place.column % kSide);
      const int count = std::min(rest_of_tile, last_x - x + 1);
      visit(x, &writable(place), count);
      x += count;
    }
  }

 private:
  /// Counted from the first cell. Cells below it turn into very large numbers.
  struct Place {
    unsigned column;
    unsigned row;
  };

  static constexpr std::uint32_t kEmptyTile = 0;  // the first one, which nobody writes
  static constexpr std::size_t kCells = static_cast<std::size_t>(kSide) * kSide;

  [[nodiscard]] Place placeOf(int x, int y) const {
    return {static_cast<unsigned>(x) - static_cast<unsigned>(origin_.x()),
            static_cast<unsigned>(y) - static_cast<unsigned>(origin_.y())};
  }
  [[nodiscard]] std::size_t tileOf(const Place& place) const {
    return static_cast<std::size_t>(place.row / kSide) * columns_ + place.column / kSide;
  }
  [[nodiscard]] static std::size_t cellOf(const Place& place) {
    return static_cast<std::size_t>(place.row % kSide) * kSide + place.column % kSide;
  }
  [[nodiscard]] Value& writable(const Place& place) {
    std::uint32_t& tile = tiles_[tileOf(place)];
    if (tile == kEmptyTile) {
      tile = static_cast<std::uint32_t>(values_.size());
      values_.resize(values_.size() + kCells);
    }
    return values_[tile + cellOf(place)];
  }

  grid::Cell origin_{0, 0};
  unsigned columns_{0};  // of tiles
  unsigned rows_{0};
  std::vector<std::uint32_t> tiles_;  // where the cells of each begin
  std::vector<Value> values_;
};

}  // namespace omega_slam::matching

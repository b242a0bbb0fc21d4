#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "omega_slam/mapping/tile.h"

namespace omega_slam::mapping {

/// One value for each tile of a plane without bounds: `Value{}` where none was set. Memory is kept
/// for the rectangle around the tiles that were set, and grows in any direction.
template <class Value>
class TileDirectory {
 public:
  /// The value of any tile, also one beyond the memory.
  [[nodiscard]] const Value& at(const TileIndex& tile) const {
    return box_.contains(tile) ? values_[indexIn(box_, tile)] : none_;
  }

  /// The value of a tile, to be set.
  [[nodiscard]] Value& operator()(const TileIndex& tile) {
    if (!box_.contains(tile)) {
      growTo(CellBox(tile));
    }
    return values_[indexIn(box_, tile)];
  }

  /// Makes room for all tiles of a box at once.
  void growTo(const CellBox& tiles) {
    if (tiles.isEmpty() || box_.contains(tiles)) {
      return;
    }
    CellBox grown = box_.merged(tiles);
    if (!box_.isEmpty()) {
      // A quarter more on the sides that grow: over a long drive, all copies together cost about as
      // much as the last one.
      const TileIndex margin = (grown.sizes().array() / 4 + 1).matrix();
      grown = CellBox(
          (grown.min().array() < box_.min().array()).select(grown.min() - margin, grown.min()),
          (grown.max().array() > box_.max().array()).select(grown.max() + margin, grown.max()));
    }
    std::vector<Value> values(count(grown));
    forEach([&](const TileIndex& tile, Value& value) {
      values[indexIn(grown, tile)] = std::move(value);
    });
    values_ = std::move(values);
    box_ = grown;
  }

  /// Calls `visit(tile, value)` for all tiles that there is memory for, row by row.
  template <class Visitor>
  void forEach(const Visitor& visit) {
    visitAll(*this, visit);
  }
  template <class Visitor>
  void forEach(const Visitor& visit) const {
    visitAll(*this, visit);
  }

  /// The rectangle that there is memory for.
  [[nodiscard]] const CellBox& box() const { return box_; }

  void clear() {
    box_.setEmpty();
    values_.clear();
  }

 private:
  [[nodiscard]] static std::size_t columns(const CellBox& box) {
    return static_cast<std::size_t>(box.sizes().x()) + 1;
  }
  [[nodiscard]] static std::size_t count(const CellBox& box) {
    return columns(box) * (static_cast<std::size_t>(box.sizes().y()) + 1);
  }
  [[nodiscard]] static std::size_t indexIn(const CellBox& box, const TileIndex& tile) {
    return static_cast<std::size_t>(tile.y() - box.min().y()) * columns(box) +
           static_cast<std::size_t>(tile.x() - box.min().x());
  }
  template <class Self, class Visitor>
  static void visitAll(Self& self, const Visitor& visit) {
    auto value = self.values_.begin();
    for (int y = self.box_.min().y(); !self.box_.isEmpty() && y <= self.box_.max().y(); ++y) {
      for (int x = self.box_.min().x(); x <= self.box_.max().x(); ++x) {
        visit(TileIndex(x, y), *value++);
      }
    }
  }

  CellBox box_;
  std::vector<Value> values_;
  Value none_{};
};

}  // namespace omega_slam::mapping

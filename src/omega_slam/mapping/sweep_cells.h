#pragma once

#include <cstdint>
#include <vector>

#include "omega_slam/mapping/tile.h"
#include "omega_slam/mapping/tile_directory.h"

namespace omega_slam::mapping {

/// What one sweep says of the cells of one tile.
struct SweepTile {
  TileIndex index{0, 0};
  TileBits occupied{};
  TileBits free{};  ///< may hold occupied cells too, which then count as occupied
};

/// What one sweep says of the cells: which it saw occupied, and which free. A cell is in a set or
/// not, however many beams have touched it.
///
/// Made to be filled again and again: the memory is kept. Not thread-safe.
class SweepCells {
 public:
  /// Forgets all. @param expected the cells that are to come, about: others may come too
  void begin(const CellBox& expected);

  void markOccupied(const grid::Cell& cell) { mark(&SweepTile::occupied, cell); }
  void markFree(const grid::Cell& cell) { mark(&SweepTile::free, cell); }
  /// Cells from `first_x` to `last_x` of a row, both included; none if `last_x < first_x`.
  void markFreeRow(int y, int first_x, int last_x) {
    if (tileOf({first_x, y}) == tileOf({last_x, y})) {
      markFreeWithin(y, first_x, last_x - first_x + 1);
    } else {
      markFreeAcross(y, first_x, last_x);
    }
  }

  [[nodiscard]] const std::vector<SweepTile>& tiles() const { return tiles_; }
  /// Of a tile; null where the sweep says nothing.
  [[nodiscard]] const SweepTile* find(const TileIndex& index) const;
  /// The cells that were marked lie in these tiles.
  [[nodiscard]] CellBox tileBox() const;

 private:
  /// `count` cells of a row, all in one tile; none if it is below 1.
  void markFreeWithin(int y, int first_x, int count) {
    if (count > 0) {
      const grid::Cell cell(first_x, y);
      const grid::Cell place = withinTile(cell);
      tileAt(tileOf(cell)).free[static_cast<std::size_t>(place.y())] |=
          ~std::uint64_t{0} >> static_cast<unsigned>(kTileSide - count)
                                   << static_cast<unsigned>(place.x());
    }
  }
  void markFreeAcross(int y, int first_x, int last_x);
  void mark(TileBits SweepTile::*bits, const grid::Cell& cell) {
    const grid::Cell place = withinTile(cell);
    (tileAt(tileOf(cell)).*bits)[static_cast<std::size_t>(place.y())] |=
        std::uint64_t{1} << static_cast<unsigned>(place.x());
  }
  [[nodiscard]] SweepTile& tileAt(const TileIndex& index) {
    if (tiles_.empty() || tiles_[newest_].index != index) {
      open(index);
    }
    return tiles_[newest_];
  }
  void open(const TileIndex& index);

  std::vector<SweepTile> tiles_;
  std::size_t newest_{0};                 ///< the tile that was marked last
  TileDirectory<std::uint32_t> numbers_;  ///< of a tile in tiles_, counted from 1
};

}  // namespace omega_slam::mapping

#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "omega_slam/mapping/cell_counts.h"
#include "omega_slam/mapping/sweep_cells.h"
#include "omega_slam/mapping/tile.h"
#include "omega_slam/mapping/tile_directory.h"

namespace omega_slam::mapping {

/// The counts of the cells of one tile, row by row.
struct CountTile {
  std::array<CellCounts, kTileCells> counts{};
  TileBits seen{};     ///< cells of which anything was counted
  TileBits vacated{};  ///< where hits do not count: whoever was there has left

  /// As they are to be judged.
  [[nodiscard]] CellCounts at(std::size_t x, std::size_t y) const {
    const CellCounts& all = counts[y * kTileSide + x];
    return (vacated[y] >> x & 1U) == 0 ? all : CellCounts{0, all.misses};
  }
};

/// All counts at one moment. They never change, so threads share them freely.
using CountTiles = TileDirectory<std::shared_ptr<const CountTile>>;

/// The smallest box that holds all cells seen; empty if there are none.
[[nodiscard]] CellBox boundsOf(const CountTiles& tiles);

/// Counts hits and misses, in tiles that are made where they are needed. Whole numbers: what was
/// added can be taken away, and all is exactly as before.
///
/// Tiles are copied on write. A snapshot shares them with the map, and a tile is copied when it is
/// to be changed for the first time after a snapshot; so whoever reads a snapshot, in whatever
/// thread and for however long, holds nobody up, and a tile that is the same object in two
/// snapshots has not changed between them. Not thread-safe: one owner writes.
class CountMap {
 public:
  /// Adds what a sweep has seen.
  void add(const SweepCells& cells);
  /// Takes away what was added before.
  void subtract(const SweepCells& cells);

  /// Says which cells of a tile are vacated. The tile must exist.
  void setVacated(const TileIndex& tile, const TileBits& vacated);

  /// All counts now. Costs as much as copying a pointer for each tile.
  [[nodiscard]] CountTiles snapshot();

  void clear();

 private:
  struct Slot {
    std::shared_ptr<CountTile> tile;
    std::uint64_t epoch{0};  ///< in which the tile was made or copied: later ones share it
  };
  [[nodiscard]] CountTile& writable(const TileIndex& index);

  TileDirectory<Slot> slots_;
  std::uint64_t epoch_{1};  ///< grows with each snapshot
};

}  // namespace omega_slam::mapping

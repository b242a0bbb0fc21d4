#include "omega_slam/mapping/count_map.h"

#include <algorithm>

namespace omega_slam::mapping {
namespace {

void addRow(CountTile& tile, std::size_t y, std::uint64_t hits, std::uint64_t misses) {
  CellCounts* const row = &tile.counts[y * kTileSide];
  forEachBit(hits, [row](std::size_t x) { ++row[x].hits; });
  forEachBit(misses, [row](std::size_t x) { ++row[x].misses; });
  tile.seen[y] |= hits | misses;
}

void subtractRow(CountTile& tile, std::size_t y, std::uint64_t hits, std::uint64_t misses) {
  CellCounts* const row = &tile.counts[y * kTileSide];
  std::uint64_t unseen = 0;
  forEachBit(hits, [&](std::size_t x) {
    --row[x].hits;
    unseen |= std::uint64_t{row[x].observations() == 0} << x;
  });
  forEachBit(misses, [&](std::size_t x) {
    --row[x].misses;
    unseen |= std::uint64_t{row[x].observations() == 0} << x;
  });
  tile.seen[y] &= ~unseen;
}

bool isEmpty(const CountTile& tile) {
  return std::all_of(tile.seen.begin(), tile.seen.end(),
                     [](std::uint64_t row) { return row == 0; });
}

CellBox boundsOf(const CountTile& tile, const TileIndex& index) {
  CellBox box;
  std::uint64_t columns = 0;
  for (int y = 0; y < kTileSide; ++y) {
    const std::uint64_t row = tile.seen[static_cast<std::size_t>(y)];
    columns |= row;
    if (row != 0) {
      box.extend(grid::Cell(cornerOf(index) + grid::Cell(__builtin_ctzll(row), y)));
    }
  }
  if (columns != 0) {
    const int last = kTileSide - 1 - __builtin_clzll(columns);
    box.extend(grid::Cell(cornerOf(index).x() + __builtin_ctzll(columns), box.min().y()));
    box.extend(grid::Cell(cornerOf(index).x() + last, box.min().y()));
  }
  return box;
}

}  // namespace

CellBox boundsOf(const CountTiles& tiles) {
  CellBox box;
  tiles.forEach([&box](const TileIndex& index, const auto& tile) {
    if (tile) {
      box.extend(boundsOf(*tile, index));
    }
  });
  return box;
}

void CountMap::add(const SweepCells& cells) {
  for (const SweepTile& seen : cells.tiles()) {
    CountTile& tile = writable(seen.index);
    for (std::size_t y = 0; y < kTileSide; ++y) {
      addRow(tile, y, seen.occupied[y], seen.free[y] & ~seen.occupied[y]);
    }
  }
}

void CountMap::subtract(const SweepCells& cells) {
  for (const SweepTile& seen : cells.tiles()) {
    CountTile& tile = writable(seen.index);
    for (std::size_t y = 0; y < kTileSide; ++y) {
      subtractRow(tile, y, seen.occupied[y], seen.free[y] & ~seen.occupied[y]);
    }
    if (isEmpty(tile)) {
      slots_(seen.index) = {};
    }
  }
}

void CountMap::setVacated(const TileIndex& tile, const TileBits& vacated) {
  if (slots_.at(tile).tile && slots_.at(tile).tile->vacated != vacated) {
    writable(tile).vacated = vacated;
  }
}

CountTiles CountMap::snapshot() {
  ++epoch_;
  CountTiles tiles;
  tiles.growTo(slots_.box());
  slots_.forEach([&tiles](const TileIndex& index, const Slot& slot) {
    if (slot.tile) {
      tiles(index) = slot.tile;
    }
  });
  return tiles;
}

void CountMap::clear() { slots_.clear(); }

CountTile& CountMap::writable(const TileIndex& index) {
  Slot& slot = slots_(index);
  if (!slot.tile) {
    slot = {std::make_shared<CountTile>(), epoch_};
  } else if (slot.epoch != epoch_) {
    slot = {std::make_shared<CountTile>(*slot.tile), epoch_};
  }
  return *slot.tile;
}

}  // namespace omega_slam::mapping

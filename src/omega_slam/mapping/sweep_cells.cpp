#include "omega_slam/mapping/sweep_cells.h"

#include <algorithm>

namespace omega_slam::mapping {

void SweepCells::begin(const CellBox& expected) {
  tiles_.clear();
  newest_ = 0;
  numbers_.clear();
  numbers_.growTo(tilesOf(expected));
}

void SweepCells::markFreeAcross(int y, int first_x, int last_x) {
  for (int x = first_x; x <= last_x;) {
    const int count = std::min(kTileSide - (x & (kTileSide - 1)), last_x - x + 1);
    markFreeWithin(y, x, count);
    x += count;
  }
}

const SweepTile* SweepCells::find(const TileIndex& index) const {
  const std::uint32_t number = numbers_.at(index);
  return number == 0 ? nullptr : &tiles_[number - 1];
}

CellBox SweepCells::tileBox() const {
  CellBox box;
  for (const SweepTile& tile : tiles_) {
    box.extend(tile.index);
  }
  return box;
}

void SweepCells::open(const TileIndex& index) {
  std::uint32_t& number = numbers_(index);
  if (number == 0) {
    tiles_.emplace_back().index = index;
    number = static_cast<std::uint32_t>(tiles_.size());
  }
  newest_ = number - 1;
}

}  // namespace omega_slam::mapping

#include "omega_slam/mapping/people_filter.h"

#include "omega_slam/grid/ray_traversal.h"

namespace omega_slam::mapping {
namespace {

/// Marks, as free, the cells of all surfaces that a sweep may have seen, and all cells around them.
void markSurfaces(const SweepRays& rays, const SweepCells& cells, SweepCells& surfaces) {
  surfaces.begin(rays.box);
  const auto markAround = [&surfaces](const grid::Cell& cell) {
    for (int y = cell.y() - 1; y <= cell.y() + 1; ++y) {
      surfaces.markFreeRow(y, cell.x() - 1, cell.x() + 1);
    }
  };
  for (const SweepTile& tile : cells.tiles()) {
    for (std::size_t y = 0; y < kTileSide; ++y) {
      forEachBit(tile.occupied[y], [&](std::size_t x) {
        markAround(cornerOf(tile.index) + grid::Cell(static_cast<int>(x), static_cast<int>(y)));
      });
    }
  }
  for (std::size_t k = 1; k < rays.rays.size(); ++k) {
    if (rays.rays[k - 1].is_hit && rays.rays[k].is_hit) {
      grid::traverseCells(rays.rays[k - 1].end, rays.rays[k].end, markAround);
    }
  }
}

/// Cells that are free and touch no surface.
TileBits passedCells(const SweepTile& tile, const SweepTile* surface) {
  TileBits passed = tile.free;
  for (std::size_t y = 0; y < kTileSide; ++y) {
    passed[y] &= ~(tile.occupied[y] | (surface != nullptr ? surface->free[y] : 0));
  }
  return passed;
}

}  // namespace

PeopleFilter::Sighting PeopleFilter::sightingOf(const SweepTile& tile, const SweepTile* surface) {
  const TileBits passed = passedCells(tile, surface);
  Sighting sighting;
  std::size_t end_row = 0;
  for (std::size_t y = 0; y < kTileSide; ++y) {
    if (passed[y] != 0) {
      sighting.first_row = end_row == 0 ? y : sighting.first_row;
      end_row = y + 1;
    }
    forEachBit(tile.occupied[y], [&sighting, y](std::size_t x) {
      sighting.hits.push_back(static_cast<std::uint16_t>(y * kTileSide + x));
    });
  }
  const auto row = [&passed](std::size_t y) {
    return passed.begin() + static_cast<std::ptrdiff_t>(y);
  };
  sighting.passed.assign(row(sighting.first_row), row(end_row));
  sighting.hits.shrink_to_fit();
  return sighting;
}

void PeopleFilter::add(SweepId id, const SweepRays& rays, const SweepCells& cells) {
  markSurfaces(rays, cells, surfaces_);
  for (const SweepTile& tile : cells.tiles()) {
    std::unique_ptr<History>& history = histories_(tile.index);
    if (!history) {
      history = std::make_unique<History>();
    }
    auto& sightings = history->sightings;
    const bool is_newest = sightings.empty() || sightings.rbegin()->first < id;
    const auto placed =
        sightings.insert_or_assign(id, sightingOf(tile, surfaces_.find(tile.index))).first;
    if (is_newest && !history->is_stale) {
      count(placed->second, *history);
    } else {
      history->is_stale = true;
    }
    unsettle(tile.index, *history);
  }
}

void PeopleFilter::remove(SweepId id, const SweepCells& cells) {
  for (const SweepTile& tile : cells.tiles()) {
    History* const history = histories_.at(tile.index).get();
    if (history != nullptr && history->sightings.erase(id) > 0) {
      history->is_stale = true;
      unsettle(tile.index, *history);
    }
  }
}

void PeopleFilter::settle(CountMap& map) {
  for (const TileIndex& index : unsettled_) {
    std::unique_ptr<History>& history = histories_(index);
    if (history->is_stale) {
      recount(*history);
    }
    history->is_unsettled = false;
    TileBits vacated = history->low;
    for (std::size_t y = 0; y < kTileSide; ++y) {
      vacated[y] &= history->high[y];
    }
    map.setVacated(index, vacated);
    if (history->sightings.empty()) {
      history.reset();
    }
  }
  unsettled_.clear();
}

void PeopleFilter::recount(History& history) {
  history.low = {};
  history.high = {};
  history.is_stale = false;
  for (const auto& [id, sighting] : history.sightings) {
    count(sighting, history);
  }
}

void PeopleFilter::clear() {
  histories_.clear();
  unsettled_.clear();
}

void PeopleFilter::count(const Sighting& sighting, History& history) {
  for (std::size_t k = 0; k < sighting.passed.size(); ++k) {
    std::uint64_t& low = history.low[sighting.first_row + k];
    std::uint64_t& high = history.high[sighting.first_row + k];
    const std::uint64_t counted = sighting.passed[k] & ~(low & high);
    high ^= low & counted;
    low ^= counted;
  }
  for (const std::uint16_t cell : sighting.hits) {
    const std::uint64_t others = ~(std::uint64_t{1} << (cell % kTileSide));
    history.low[cell / kTileSide] &= others;
    history.high[cell / kTileSide] &= others;
  }
}

void PeopleFilter::unsettle(const TileIndex& index, History& history) {
  if (!history.is_unsettled) {
    history.is_unsettled = true;
    unsettled_.push_back(index);
  }
}

}  // namespace omega_slam::mapping

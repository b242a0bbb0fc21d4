#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "omega_slam/mapping/count_map.h"
#include "omega_slam/mapping/sweep_cells.h"
#include "omega_slam/mapping/sweep_rays.h"
#include "omega_slam/mapping/tile_directory.h"

namespace omega_slam::mapping {

/// Sweeps are known by numbers that grow with time.
using SweepId = std::uint64_t;

/// Finds the cells that people, doors and chairs have left: they were hit, and after the last hit
/// three sweeps, in the order of their numbers, have plainly seen through them. A share of hits
/// can't know that: who stood in the way for long has collected many.
///
/// A sweep plainly sees through a free cell unless the cell touches a surface that this same sweep
/// has seen: a hit, or a line that joins the hits of neighbouring beams. Along a wall seen at a
/// grazing angle, beams pass through cells of the wall; these must not count against it.
///
/// What each sweep says is kept, as bits, so that a sweep can be taken out again, or put in late:
/// what counts is the set of sweeps that are in, never the order of the calls. Appending the newest
/// costs as much as the sweep is large; anything else makes the tiles that it touches count anew
/// what all their sweeps have said. Not thread-safe.
class PeopleFilter {
 public:
  /// @param cells what the renderer made of the rays
  void add(SweepId id, const SweepRays& rays, const SweepCells& cells);
  /// @param cells what was added by that number
  void remove(SweepId id, const SweepCells& cells);

  /// Tells the map which cells are vacated, in the tiles where that may have changed.
  void settle(CountMap& map);

  void clear();

 private:
  /// What one sweep says of a tile: rows of cells that it saw through, and cells that it hit.
  struct Sighting {
    std::size_t first_row{0};
    std::vector<std::uint64_t> passed;  ///< from first_row on
    std::vector<std::uint16_t> hits;    ///< cells of the tile, row-major
  };
  /// The sweeps that have touched a tile, and how often each cell was seen through since it was hit
  /// last: a number of two bits that stays at 3, of which each plane holds one.
  struct History {
    std::map<SweepId, Sighting> sightings;
    TileBits low{};
    TileBits high{};
    bool is_stale{false};      ///< the planes must be counted anew
    bool is_unsettled{false};  ///< the map does not know yet
  };
  [[nodiscard]] static Sighting sightingOf(const SweepTile& tile, const SweepTile* surface);
  static void count(const Sighting& sighting, History& history);
  static void recount(History& history);
  void unsettle(const TileIndex& index, History& history);

  TileDirectory<std::unique_ptr<History>> histories_;
  std::vector<TileIndex> unsettled_;
  SweepCells surfaces_;  ///< cells that touch a surface; kept to spare allocations
};

}  // namespace omega_slam::mapping

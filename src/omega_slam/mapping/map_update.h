#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "omega_slam/mapping/occupancy_mapper.h"

namespace omega_slam::mapping {

/// What one update has done.
struct UpdateReport {
  std::size_t drawn{0};               ///< sweeps drawn just now, whether new or moved
  std::size_t moved{0};               ///< sweeps that lay elsewhere before
  std::size_t removed{0};             ///< sweeps that are gone
  bool is_redrawn{false};             ///< whether all was drawn again
  std::vector<std::string> refusals;  ///< why sweeps could not be drawn, once for each

  [[nodiscard]] bool hasChanged() const { return drawn + moved + removed > 0; }
};

/// Brings a map in step with the graph: new sweeps are put in, those that are gone are taken out,
/// and those that have moved so far that the end of their farthest beam lies half a cell from where
/// it was drawn are taken out and put back. All others stay, so the work is in proportion to what
/// has changed. Where more than half have moved, the map is drawn anew: the same map, for less.
///
/// @param sweeps all that the map is to show, where they are to be; by growing numbers
UpdateReport update(OccupancyMapper& mapper, const std::vector<PlacedSweep>& sweeps);

}  // namespace omega_slam::mapping

#pragma once

#include "omega_slam/exploration/contour.h"
#include "omega_slam/exploration/frontier_store.h"

namespace omega_slam::exploration {

/// Fast frontier detection (the paper, section 4.2; Keidar and Kaminka, IJRR 33(2), 2014): only the
/// contour of the newest sweep is searched for new frontier cells, and of the stored ones only
/// those within what the sweep has touched are looked at again. The time for a sweep depends on
/// what it has seen and not on the size of the map.
///
/// Why this finds all: a sweep changes only cells that its beams cross or end in. A cell becomes a
/// frontier, or ceases to be one, only if it or a cell next to it changes. A stored cell that
/// ceases is within the box that the sweep has touched. A cell that becomes one is unknown, so that
/// no beam has crossed it, and lies next to one that was crossed: on the outline of the sweep. This
/// holds where neighbouring beams are less than a cell apart, for a Hokuyo with cells of 5 cm up to
/// 8 m.
///
/// Deviations: Keidar and Kaminka find out which part of an old frontier was seen before by keeping
/// a grid of ids; we keep a hash of cells, so that a map that grows costs nothing. Not thread-safe.
class FastDetector {
 public:
  /// The map now has a sweep in it that it had not before. Call it for each, in any order; sweeps
  /// that have come into the map together may be told one after the other, with the same map.
  void update(const MapView& map, const Contour& contour);

  /// Forgets what it knows of cells and searches the whole map; ids live on where frontiers do.
  void searchAll(const MapView& map);

  /// The map has moved: stored frontiers follow it. Call searchAll() when it is drawn anew.
  /// @param map as it was before
  void move(const geometry::MapMotion& motion, const MapView& map) { store_.move(motion, map); }

  [[nodiscard]] const FrontierStore& store() const { return store_; }

 private:
  FrontierStore store_;
};

/// All frontier cells of a map, connected with the robot or not; time is linear in all cells.
[[nodiscard]] std::vector<Cell> allFrontierCells(const MapView& map);

}  // namespace omega_slam::exploration

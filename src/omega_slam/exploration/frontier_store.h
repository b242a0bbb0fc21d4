#pragma once

#include <map>
#include <vector>

#include "omega_slam/exploration/frontier.h"
#include "omega_slam/geometry/map_motion.h"

namespace omega_slam::exploration {

/// The frontiers that are known, by ids that last: a frontier keeps its id while it grows, shrinks
/// or moves by a cell; of those that merge the larger share gives the name, and of the parts of one
/// that falls apart the larger part keeps it. Ids are never used twice. Not thread-safe.
class FrontierStore {
 public:
  using Frontiers = std::map<FrontierId, Frontier>;

  [[nodiscard]] const Frontiers& all() const { return frontiers_; }
  [[nodiscard]] FrontierId ownerOf(const Cell& cell) const;  ///< 0 if it belongs to none

  /// Puts `fresh` frontiers, which come without ids, in the place of the `old` ones.
  void replace(const std::vector<FrontierId>& old, std::vector<Frontier> fresh);
  void replaceAll(std::vector<Frontier> fresh);

  /// Carries the cells along with a map that has moved; what they are now, replaceAll() must say.
  void move(const geometry::MapMotion& motion, const MapView& map);

 private:
  void insert(Frontier frontier);

  Frontiers frontiers_;
  CellMap<FrontierId> owners_;
  FrontierId next_id_{1};
};

}  // namespace omega_slam::exploration

#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "nodes/common/keyframe_store.h"
#include "omega_slam/exploration/explorer.h"

namespace omega_slam {

/// What is new in a map, by the keyframes that it was drawn from. Where there are no keyframes,
/// because somebody else draws the map, there is never any news. Not thread-safe.
class MapNews {
 public:
  struct News {
    std::vector<mapping::PlacedSweep> keyframes;  ///< that this map has and the last one had not;
                                                  ///< empty: anything may have changed
    std::optional<geometry::MapMotion> motion;    ///< if keyframes have moved
  };

  void addKeyframe(std::uint64_t run, slam::Keyframe keyframe) {
    store_.add(run, std::move(keyframe));
  }
  void setPoses(std::uint64_t run, std::vector<geometry::Pose2> T_map_keyframes) {
    store_.setPoses(run, std::move(T_map_keyframes));
  }

  /// @param stamp [s] of the newest keyframe in the map
  /// @param resolution [m] of the map: it is drawn anew once the end of a beam is half a cell off
  [[nodiscard]] News take(double stamp, double resolution);

 private:
  KeyframeStore store_;
  std::set<mapping::SweepId> shown_;
  std::vector<geometry::Pose2> poses_;  ///< of all keyframes at the last map
  int unsettled_maps_{0};  ///< the map may lag behind the graph: so many may still be drawn anew
};

}  // namespace omega_slam

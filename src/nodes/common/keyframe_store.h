#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/mapping/occupancy_mapper.h"
#include "omega_slam/slam/keyframe.h"

namespace omega_slam {

/// The keyframes of one run and the newest poses of the graph, which arrive in any order, perhaps
/// twice, or from another run. Not thread-safe.
class KeyframeStore {
 public:
  enum class Verdict {
    kTaken,
    kKnown,    ///< came before; nothing to do
    kNewRun,   ///< another run has begun; all before is forgotten
    kOtherRun  ///< refused
  };

  /// A new run begins with its keyframe 0, or with any where there was no run before.
  Verdict add(std::uint64_t run, slam::Keyframe keyframe);

  /// Poses `T_map_i` of a run; those of a run that has not begun yet wait for it. No poses at all:
  /// that run was reset, and its keyframes are forgotten.
  void setPoses(std::uint64_t run, std::vector<geometry::Pose2> T_map_keyframes);

  /// Sweeps of the keyframes that have a pose, by id.
  [[nodiscard]] std::vector<mapping::PlacedSweep> placed() const;
  [[nodiscard]] std::size_t size() const { return keyframes_.size(); }
  /// Keyframes that the graph has and that never came here.
  [[nodiscard]] std::size_t missing() const;

 private:
  std::uint64_t run_{0};  ///< 0: none
  std::map<graph::NodeId, slam::KeyframePtr> keyframes_;
  std::uint64_t poses_run_{0};
  std::vector<geometry::Pose2> poses_;
};

}  // namespace omega_slam

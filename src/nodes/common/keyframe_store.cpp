#include "nodes/common/keyframe_store.h"

#include <memory>
#include <utility>

namespace omega_slam {

KeyframeStore::Verdict KeyframeStore::add(std::uint64_t run, slam::Keyframe keyframe) {
  const graph::NodeId id = keyframe.id;
  auto shared = std::make_shared<const slam::Keyframe>(std::move(keyframe));
  if (run == run_) {
    return keyframes_.emplace(id, std::move(shared)).second ? Verdict::kTaken : Verdict::kKnown;
  }
  if (run_ != 0 && id != 0) {
    return Verdict::kOtherRun;
  }
  keyframes_.clear();
  run_ = run;
  keyframes_.emplace(id, std::move(shared));
  return Verdict::kNewRun;
}

void KeyframeStore::setPoses(std::uint64_t run, std::vector<geometry::Pose2> T_map_keyframes) {
  if (T_map_keyframes.empty() && run == run_) {
    keyframes_.clear();
  }
  poses_run_ = run;
  poses_ = std::move(T_map_keyframes);
}

std::vector<mapping::PlacedSweep> KeyframeStore::placed() const {
  std::vector<mapping::PlacedSweep> placed;
  if (poses_run_ != run_) {
    return placed;
  }
  for (const auto& [id, keyframe] : keyframes_) {
    if (id < poses_.size()) {
      placed.push_back({id, slam::sweepOf(keyframe), poses_[id]});
    }
  }
  return placed;
}

std::size_t KeyframeStore::missing() const {
  return poses_run_ == run_ ? poses_.size() - placed().size() : 0;
}

}  // namespace omega_slam

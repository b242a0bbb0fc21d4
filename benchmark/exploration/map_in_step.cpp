#include "exploration/map_in_step.h"

namespace omega_slam::experiments {
namespace {

constexpr double kReach = 4.0;        // [m] of beams
constexpr double kTolerance = 0.025;  // [m] half a cell

}  // namespace

MapInStep::Change MapInStep::update(const slam::Pipeline& pipeline) {
  Change change;
  const auto& keyframes = pipeline.keyframes();
  std::vector<geometry::Pose2> poses;
  for (const slam::KeyframePtr& keyframe : keyframes) {
    poses.push_back(pipeline.graph().poses[keyframe->id]);
  }
  const exploration::MapMotion motion(drawn_, poses);
  const bool moved = motion.exceeds(kTolerance, kReach);
  change.is_new = moved || poses.size() > drawn_.size();
  if (moved) {
    change.motion = motion;
    mapper_.clear();
    drawn_.clear();
  }
  for (std::size_t i = drawn_.size(); i < keyframes.size(); ++i) {
    (void)mapper_.add(keyframes[i]->sweep, poses[i]);
    drawn_.push_back(poses[i]);
    if (!moved) {
      change.news.push_back({&keyframes[i]->sweep, poses[i]});
    }
  }
  return change;
}

}  // namespace omega_slam::experiments

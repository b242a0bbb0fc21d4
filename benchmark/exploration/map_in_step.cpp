#include "exploration/map_in_step.h"

#include <utility>

#include "omega_slam/mapping/map_update.h"

namespace omega_slam::experiments {

MapInStep::Change MapInStep::update(const Localisation& localisation) {
  std::vector<mapping::PlacedSweep> placed;
  std::vector<geometry::Pose2> poses;
  for (const slam::KeyframePtr& keyframe : localisation.keyframes()) {
    poses.push_back(localisation.poses()[keyframe->id]);
    placed.push_back({keyframe->id, slam::sweepOf(keyframe), poses.back()});
  }
  const mapping::UpdateReport report = mapping::update(mapper_, placed);
  Change change;
  change.is_new = report.hasChanged();
  if (report.is_redrawn || report.moved > 0) {
    change.motion = geometry::MapMotion(poses_, poses);
  } else {
    for (std::size_t i = poses_.size(); i < placed.size(); ++i) {
      change.news.push_back({placed[i].sweep.get(), poses[i]});
    }
  }
  poses_ = std::move(poses);
  return change;
}

}  // namespace omega_slam::experiments

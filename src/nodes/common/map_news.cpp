#include "nodes/common/map_news.h"

#include <algorithm>

namespace omega_slam {
namespace {

constexpr double kReach = 4.0;       // [m] of beams, whose ends must not be off
constexpr int kUnsettledMaps = 2;    // after a graph has moved: the one on its way, and the next
constexpr double kSameStamp = 1e-6;  // [s] messages carry nanoseconds, doubles almost

}  // namespace

MapNews::News MapNews::take(double stamp, double resolution) {
  const std::vector<mapping::PlacedSweep> placed = store_.placed();
  std::vector<geometry::Pose2> poses;
  poses.reserve(placed.size());
  for (const mapping::PlacedSweep& keyframe : placed) {
    poses.push_back(keyframe.T_map_base);
  }
  News news;
  const geometry::MapMotion motion(poses_, poses);
  if (poses.size() < poses_.size()) {  // another run
    shown_.clear();
    unsettled_maps_ = kUnsettledMaps;
  } else if (motion.exceeds(0.5 * resolution, kReach)) {
    news.motion = motion;
    unsettled_maps_ = kUnsettledMaps;
  }
  poses_ = poses;
  for (const mapping::PlacedSweep& keyframe : placed) {
    if (keyframe.sweep->stamp <= stamp + kSameStamp && shown_.insert(keyframe.id).second) {
      news.keyframes.push_back(keyframe);
    }
  }
  if (unsettled_maps_ > 0) {
    --unsettled_maps_;
    news.keyframes.clear();
  }
  return news;
}

}  // namespace omega_slam

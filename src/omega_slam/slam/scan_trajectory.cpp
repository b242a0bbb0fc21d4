#include "omega_slam/slam/scan_trajectory.h"

#include <cstddef>

namespace omega_slam::slam {

using geometry::Pose2;

namespace {

/// For each scan the keyframe scan at or after it; as many as there are scans where there is none.
std::vector<std::size_t> nextKeyframes(const std::vector<ScanTrack>& tracks) {
  std::vector<std::size_t> next(tracks.size());
  std::size_t newest = tracks.size();
  for (std::size_t i = tracks.size(); i-- > 0;) {
    newest = tracks[i].is_keyframe ? i : newest;
    next[i] = newest;
  }
  return next;
}

}  // namespace

geometry::Trajectory scanTrajectory(const std::vector<ScanTrack>& tracks,
                                    const std::vector<Pose2>& poses) {
  const std::vector<std::size_t> next = nextKeyframes(tracks);
  geometry::Trajectory trajectory;
  trajectory.reserve(tracks.size());
  std::size_t last = 0;  // scan of the keyframe before
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const ScanTrack& track = tracks[i];
    if (track.keyframe >= poses.size()) {
      continue;
    }
    Pose2 T_map_base = poses[track.keyframe] * track.T_keyframe_base;
    const std::size_t end = next[i];
    const bool has_end = end < tracks.size() && tracks[end].keyframe == track.keyframe &&
                         track.keyframe + std::size_t{1} < poses.size() && end > last;
    if (has_end) {
      const Pose2 T_end_base = relativePose(tracks[end].T_keyframe_base, track.T_keyframe_base);
      const double share = static_cast<double>(i - last) / static_cast<double>(end - last);
      T_map_base = interpolate(T_map_base, poses[track.keyframe + 1] * T_end_base, share);
    }
    trajectory.push_back({track.stamp, T_map_base});
    last = track.is_keyframe ? i : last;
  }
  return trajectory;
}

}  // namespace omega_slam::slam

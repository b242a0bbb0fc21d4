#pragma once

#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::slam {

/// Where a scan was tracked, in a way that survives the graph's moving.
struct ScanTrack {
  double stamp{0.0};                ///< [s]
  graph::NodeId keyframe{0};        ///< the newest before the scan; the first scan has itself
  geometry::Pose2 T_keyframe_base;  ///< seen from it
  bool is_keyframe{false};          ///< whether the scan has become the next one, or the first
};

/// One pose `T_map_base` for each scan: at a keyframe its solved pose, between two keyframes what
/// was tracked, carried on from the one and back from the other, and blended by the count of scans
/// (stamps of old logs run backwards now and then). After the last keyframe it is carried on alone.
///
/// @param tracks in the order of the run; those of a keyframe that has no pose are left out
/// @param poses  `T_map_keyframe` of keyframes 0, 1, ...
[[nodiscard]] geometry::Trajectory scanTrajectory(const std::vector<ScanTrack>& tracks,
                                                  const std::vector<geometry::Pose2>& poses);

}  // namespace omega_slam::slam

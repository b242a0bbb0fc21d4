#pragma once

#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::experiments {

/// How sharp the walls are that scans make together. Less is sharper, in both.
struct Crispness {
  double wall_distance{0.0};  ///< [m] mean distance of a scan's endpoints to the wall they lie in
  double entropy{0.0};        ///< mean map entropy [nats]
};

/// Each endpoint lies in a wall: the line that fits best to all endpoints, of whatever scan, within
/// 30 cm. A wall that was drawn twice, side by side, or blurred, lies far from its own middle.
///
/// The entropy is that of a normal distribution fitted to the same points, 1/2 ln det(2 pi e
/// Sigma), averaged over all endpoints (Droeschel, Stueckler and Behnke, "Local multi-resolution
/// representation for 6D motion estimation and mapping with a continuously rotating 3D laser
/// scanner", ICRA 2014), here in the plane. Endpoints with fewer than ten others near them say
/// nothing.
/// @param views what scans saw, seen from the base; @param poses `T_map_base`, as many
[[nodiscard]] Crispness judgeCrispness(const std::vector<matching::View>& views,
                                       const std::vector<geometry::Pose2>& poses);

}  // namespace omega_slam::experiments

#pragma once

#include <Eigen/Core>
#include <vector>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::geometry {

/// How a map has moved when its graph was solved anew: each keyframe has carried what lies around
/// it along. A point goes with the keyframe that was nearest to it.
class MapMotion {
 public:
  MapMotion() = default;  ///< nothing moves

  /// @param before, after `T_map_base` of the same keyframes, in the same order; the longer of the
  /// two is cut
  MapMotion(std::vector<Pose2> before, std::vector<Pose2> after);

  /// Whether a point within `reach` [m] of a keyframe may have moved by more than `tolerance` [m].
  [[nodiscard]] bool exceeds(double tolerance, double reach) const;

  /// [m] where a point of the old map lies in the new one.
  [[nodiscard]] Eigen::Vector2d apply(const Eigen::Vector2d& point) const;
  [[nodiscard]] Pose2 apply(const Pose2& pose) const;

 private:
  /// `T_new_old` of what lies around a point.
  [[nodiscard]] Pose2 around(const Eigen::Vector2d& point) const;

  std::vector<Pose2> before_;
  std::vector<Pose2> after_;
};

}  // namespace omega_slam::geometry

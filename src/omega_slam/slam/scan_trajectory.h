#pragma once

#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/motion/odometry_buffer.h"

namespace omega_slam::slam {

/// A keyframe as its place in the run tells it: when, what the odometry said, where the graph has
/// it.
struct KeyframePlacement {
  double stamp{0.0};            ///< [s]
  geometry::Pose2 T_odom_base;  ///< odometry at the stamp
  geometry::Pose2 T_map_base;   ///< solved pose
};

/// Odometry between two keyframes, bent so that it meets both: carried on from the one, carried
/// back from the other, and blended. @param share 0 at `before`, 1 at `after`; @return `T_map_base`
[[nodiscard]] geometry::Pose2 poseBetween(const KeyframePlacement& before,
                                          const KeyframePlacement& after,
                                          const geometry::Pose2& T_odom_base, double share);

/// Where odometry alone puts the base, seen from a keyframe's solved pose: `T_map_base`.
[[nodiscard]] geometry::Pose2 carryOn(const KeyframePlacement& keyframe,
                                      const geometry::Pose2& T_odom_base);

/// One pose `T_map_base` for each scan: at a keyframe its solved pose, between two keyframes the
/// odometry carried on from the one and back from the other, blended by time; before the first and
/// after the last keyframe the odometry alone.
///
/// @param stamps    [s] of the scans, any order; the result keeps it
/// @param odometry  must cover the stamps: a scan that it does not cover gets no pose
/// @param keyframes in the order of their stamps; with none there is no trajectory
[[nodiscard]] geometry::Trajectory scanTrajectory(const std::vector<double>& stamps,
                                                  const motion::OdometryBuffer& odometry,
                                                  const std::vector<KeyframePlacement>& keyframes);

}  // namespace omega_slam::slam

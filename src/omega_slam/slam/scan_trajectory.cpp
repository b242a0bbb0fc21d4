#include "omega_slam/slam/scan_trajectory.h"

#include <algorithm>
#include <iterator>

namespace omega_slam::slam {
namespace {

/// Where odometry alone puts the base, seen from a keyframe's solved pose: `T_map_base`.
geometry::Pose2 carryOn(const KeyframePlacement& keyframe, const geometry::Pose2& T_odom_base) {
  return keyframe.T_map_base * geometry::relativePose(keyframe.T_odom_base, T_odom_base);
}

geometry::Pose2 poseBetween(const std::vector<KeyframePlacement>& keyframes, double stamp,
                            const geometry::Pose2& T_odom_base) {
  const auto next = std::upper_bound(
      keyframes.begin(), keyframes.end(), stamp,
      [](double value, const KeyframePlacement& keyframe) { return value < keyframe.stamp; });
  if (next == keyframes.begin()) {
    return carryOn(*next, T_odom_base);
  }
  const auto previous = std::prev(next);
  if (next == keyframes.end()) {
    return carryOn(*previous, T_odom_base);
  }
  const double share = (stamp - previous->stamp) / (next->stamp - previous->stamp);
  return geometry::interpolate(carryOn(*previous, T_odom_base), carryOn(*next, T_odom_base), share);
}

}  // namespace

geometry::Trajectory scanTrajectory(const std::vector<double>& stamps,
                                    const motion::OdometryBuffer& odometry,
                                    const std::vector<KeyframePlacement>& keyframes) {
  geometry::Trajectory trajectory;
  if (keyframes.empty()) {
    return trajectory;
  }
  trajectory.reserve(stamps.size());
  for (const double stamp : stamps) {
    if (const auto T_odom_base = odometry.at(stamp)) {
      trajectory.push_back({stamp, poseBetween(keyframes, stamp, *T_odom_base)});
    }
  }
  return trajectory;
}

}  // namespace omega_slam::slam

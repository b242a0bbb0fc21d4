#include "omega_slam/slam/scan_trajectory.h"

#include <algorithm>
#include <iterator>

namespace omega_slam::slam {
using geometry::Pose2;

namespace {

Pose2 poseAmong(const std::vector<KeyframePlacement>& keyframes, double stamp,
                const Pose2& T_odom_base) {
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
  return poseBetween(*previous, *next, T_odom_base, share);
}

}  // namespace

Pose2 carryOn(const KeyframePlacement& keyframe, const Pose2& T_odom_base) {
  return keyframe.T_map_base * relativePose(keyframe.T_odom_base, T_odom_base);
}

Pose2 poseBetween(const KeyframePlacement& before, const KeyframePlacement& after,
                  const Pose2& T_odom_base, double share) {
  return interpolate(carryOn(before, T_odom_base), carryOn(after, T_odom_base), share);
}

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
      trajectory.push_back({stamp, poseAmong(keyframes, stamp, *T_odom_base)});
    }
  }
  return trajectory;
}

}  // namespace omega_slam::slam

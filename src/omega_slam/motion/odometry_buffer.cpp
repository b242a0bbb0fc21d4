#include "omega_slam/motion/odometry_buffer.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::motion {

using geometry::Pose2;
using geometry::StampedPose2;

OdometryBuffer::OdometryBuffer(double horizon, double jump) : horizon_(horizon), jump_(jump) {}

OdometryVerdict OdometryBuffer::add(double stamp, const Pose2& T_odom_base) {
  if (!std::isfinite(stamp) || !T_odom_base.isFinite()) {
    return OdometryVerdict::kNotFinite;
  }
  OdometryVerdict verdict = OdometryVerdict::kAccepted;
  if (!poses_.empty()) {
    if (stamp == newest()) {
      return OdometryVerdict::kDuplicate;
    }
    if (stamp < newest() - jump_) {
      poses_.clear();
      verdict = OdometryVerdict::kTimeJumpedBack;
    } else if (stamp < newest()) {
      return OdometryVerdict::kOutOfOrder;
    }
  }
  poses_.push_back({stamp, T_odom_base});
  while (poses_.front().stamp < stamp - horizon_) {
    poses_.pop_front();
  }
  return verdict;
}

bool OdometryBuffer::covers(double stamp) const {
  return !poses_.empty() && stamp >= oldest() && stamp <= newest();
}

std::optional<Pose2> OdometryBuffer::at(double stamp) const {
  if (!covers(stamp)) {
    return std::nullopt;
  }
  const auto after =
      std::lower_bound(poses_.begin(), poses_.end(), stamp,
                       [](const StampedPose2& pose, double t) { return pose.stamp < t; });
  if (after->stamp == stamp) {
    return after->pose;
  }
  const auto before = std::prev(after);
  const double share = (stamp - before->stamp) / (after->stamp - before->stamp);
  return interpolate(before->pose, after->pose, share);
}

}  // namespace omega_slam::motion

#include "omega_slam/matching/scan_motion.h"

#include <cmath>

namespace omega_slam::matching {

using geometry::Pose2;

Eigen::Vector3d ScanMotion::fromPose(const Pose2& T_reference_scan) const {
  const Eigen::Vector2d movement = T_reference_scan * p_scan_laser_ - p_reference_laser_;
  const double distance = std::hypot(movement.x(), movement.y());
  const double direction =
      distance > 0.0 ? std::atan2(movement.y(), movement.x()) : T_reference_scan.theta;
  return {direction, distance, T_reference_scan.theta};
}

Pose2 ScanMotion::toPose(const Eigen::Vector3d& motion) const {
  const Eigen::Vector2d heading(std::cos(motion[kDirection]), std::sin(motion[kDirection]));
  const Eigen::Vector2d arm = Pose2{0.0, 0.0, motion[kRotation]} * p_scan_laser_;
  const Eigen::Vector2d position = p_reference_laser_ + motion[kDistance] * heading - arm;
  return Pose2::fromVector({position.x(), position.y(), motion[kRotation]});
}

}  // namespace omega_slam::matching

#pragma once

#include <Eigen/Core>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// The variables of the paper's "two dimensional odometry model" (section 6.4, "Hillclimbing"), in
/// the order of the vectors below.
enum MotionVariable { kDirection, kDistance, kRotation };

/// Turns poses of a scan into movements of its laser, from where the newest view of the reference
/// was taken, and back. A movement is a vector of
/// - the direction of movement [rad], in the reference's frame,
/// - the distance between the two lasers [m]; negative is backwards,
/// - the rotation of the scan [rad], in the reference's frame. (The odometry motion model of
///   Probabilistic Robotics has it relative to the direction: rot2 = rotation - direction.)
class ScanMotion {
 public:
  /// @param reference not empty
  ScanMotion(const Reference& reference, const View& scan)
      : p_reference_laser_(reference.back().origin), p_scan_laser_(scan.origin) {}

  /// Where the scan's laser has not moved, its direction is the scan's heading.
  [[nodiscard]] Eigen::Vector3d fromPose(const geometry::Pose2& T_reference_scan) const;
  [[nodiscard]] geometry::Pose2 toPose(const Eigen::Vector3d& motion) const;

 private:
  Eigen::Vector2d p_reference_laser_;
  Eigen::Vector2d p_scan_laser_;
};

}  // namespace omega_slam::matching

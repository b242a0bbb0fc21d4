#pragma once

#include <Eigen/Core>

#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/motion/motion_predictor.h"
#include "omega_slam/slam/keyframe.h"
#include "omega_slam/slam/odometry_calibration.h"
#include "omega_slam/slam/odometry_scale.h"
#include "omega_slam/slam/scan_tracker.h"

namespace omega_slam::slam {

/// What the odometry says, as far as it has proved right: without what is always wrong with it,
/// with as much noise as it has, and not where it jumps or the wheels slip.
class WeighedOdometry {
 public:
  /// Odometry that claims to be faster than this [m/s], [rad/s] has jumped.
  WeighedOdometry(double max_speed, double max_turn_rate)
      : max_speed_(max_speed), max_turn_rate_(max_turn_rate) {}

  /// The first scan, which is a keyframe.
  void begin(const motion::Prediction& prediction);

  /// The motion since the last scan; none is known where the odometry has jumped. Predictions tell
  /// the uncertainty since the last keyframe; what it has grown by is that of the step. Where they
  /// tell less than before, there has been a keyframe, and all of it is.
  [[nodiscard]] OdometryStep stepTo(const motion::Prediction& prediction);

  /// What it says of the motion between two keyframes. Where a trusted match contradicts it, it is
  /// loosened until it does not; where it has jumped, what was tracked stands in for it.
  /// @param covariance_in_odom of just that motion, in the axes of the odometry frame
  /// @param T_local_from where the first of them lies, in the frame of what was tracked
  [[nodiscard]] graph::Constraint constraint(const Keyframe& from, const Keyframe& to,
                                             const Eigen::Matrix3d& covariance_in_odom,
                                             const geometry::Pose2& T_local_from,
                                             const TrackedScan& tracked) const;

  /// Learns from what was seen how far the odometry between two keyframes was off. Parameters as
  /// for constraint().
  void weigh(const Keyframe& from, const Keyframe& to, const Eigen::Matrix3d& covariance_in_odom,
             const geometry::Pose2& T_local_from, const Belief& matched);

  /// From here on, hasJumped() speaks of what comes after a new keyframe.
  void anchor() { has_jumped_ = false; }
  [[nodiscard]] bool hasJumped() const { return has_jumped_; }  ///< since the newest keyframe
  [[nodiscard]] OdometryFaults faults() const { return calibration_.faults(); }

 private:
  [[nodiscard]] Eigen::Matrix3d growthTo(const motion::Prediction& prediction) const;
  /// Of the odometry's variances, for a motion that it has felt.
  [[nodiscard]] double scaleFor(const geometry::Pose2& motion) const;

  double max_speed_;
  double max_turn_rate_;
  OdometryCalibration calibration_;
  OdometryScale scale_;      ///< of motions that are corrected by it,
  OdometryScale raw_scale_;  ///< and of those that can't be
  motion::Prediction last_;  ///< at the last scan
  bool has_jumped_{false};
};

}  // namespace omega_slam::slam

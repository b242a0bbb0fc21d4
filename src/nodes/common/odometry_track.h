#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <utility>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/motion/motion_predictor.h"
#include "omega_slam/motion/odometry_buffer.h"

namespace omega_slam {

/// The recent predictions of motion_model, to be asked for the moment of a scan. Poses are
/// interpolated; a covariance is the one of the first prediction at or after the moment, so that it
/// never promises too much. Not thread-safe.
class OdometryTrack {
 public:
  /// On kTimeJumpedBack only the new prediction is left.
  motion::OdometryVerdict add(const motion::Prediction& prediction);

  /// Whether both moments [s] lie within what is held.
  [[nodiscard]] bool covers(double from, double to) const;
  /// Whether the moment [s] is older than all that is held: waiting will not help.
  [[nodiscard]] bool isTooOld(double stamp) const;
  [[nodiscard]] std::optional<double> newest() const;  ///< [s]

  /// None if the moment [s] is not covered.
  [[nodiscard]] std::optional<motion::Prediction> at(double stamp) const;
  /// `T_start_end` of the base from the moment `start` [s] until `duration` [s] later; the identity
  /// where either is not covered.
  [[nodiscard]] geometry::Pose2 motionDuring(double start, double duration) const;

 private:
  motion::OdometryBuffer poses_;
  std::deque<std::pair<double, Eigen::Matrix3d>> covariances_;  ///< by stamp, as poses_
};

}  // namespace omega_slam

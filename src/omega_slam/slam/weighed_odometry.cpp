#include "omega_slam/slam/weighed_odometry.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/covariance.h"

namespace omega_slam::slam {

using geometry::Pose2;
using graph::Constraint;

namespace {

/// No odometry is better than this between two keyframes, even of a robot that stands: floors and
/// bumps.
constexpr double kFloorTranslation = 0.01;  // [m]
constexpr double kFloorRotation = 0.005;    // [rad]

/// Squared Mahalanobis distance from which on the odometry between two keyframes counts as wrong.
constexpr double kSlip = 16.0;

/// Of what the odometry's variance grows by with a step. Steps that follow each other share their
/// errors, so that most of the growth is of what matches have seen already on the steps before.
constexpr double kStepShare = 0.3;

/// [s] by which stamps may be wrong: some computers hand on late what came in time.
constexpr double kLatency = 0.3;

/// What is known of a motion during which the odometry has jumped, at least.
constexpr double kJumpTranslation = 0.5;  // [m]
constexpr double kJumpRotation = 0.5;     // [rad]

Eigen::Matrix3d nearlyNothing() {
  return Eigen::Vector3d(kJumpTranslation, kJumpTranslation, kJumpRotation)
      .cwiseAbs2()
      .asDiagonal();
}

Eigen::Matrix3d withoutNegatives(const Eigen::Matrix3d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(matrix);
  return axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).asDiagonal() *
         axes.eigenvectors().transpose();
}

}  // namespace

void WeighedOdometry::begin(const motion::Prediction& prediction) {
  last_ = prediction;
  last_.covariance.setZero();
}

OdometryStep WeighedOdometry::stepTo(const motion::Prediction& prediction) {
  OdometryStep step;
  step.motion = relativePose(last_.T_odom_base, prediction.T_odom_base);
  step.seconds = prediction.stamp - last_.stamp;
  const double most = std::max(step.seconds, 0.0) + kLatency;
  step.has_jumped = std::hypot(step.motion.x, step.motion.y) > max_speed_ * most ||
                    std::abs(step.motion.theta) > max_turn_rate_ * most;
  if (step.has_jumped) {
    has_jumped_ = true;
    step.motion = {};
    step.covariance = nearlyNothing();
  } else {
    step.covariance = kStepShare * scaleFor(step.motion) *
                      geometry::rotateCovariance(growthTo(prediction), -last_.T_odom_base.theta);
    step.motion = calibration_.corrected(step.motion);
  }
  last_ = prediction;
  return step;
}

double WeighedOdometry::scaleFor(const Pose2& motion) const {
  return (OdometryCalibration::isFor(motion) ? scale_ : raw_scale_).value();
}

/// In the axes of the odometry frame.
Eigen::Matrix3d WeighedOdometry::growthTo(const motion::Prediction& prediction) const {
  Eigen::Matrix3d moved = Eigen::Matrix3d::Identity();
  moved(0, 2) = -(prediction.T_odom_base.y - last_.T_odom_base.y);
  moved(1, 2) = prediction.T_odom_base.x - last_.T_odom_base.x;
  const Eigen::Matrix3d before = moved * last_.covariance * moved.transpose();
  const bool is_counted_anew = prediction.covariance.trace() < before.trace();
  return is_counted_anew ? prediction.covariance : withoutNegatives(prediction.covariance - before);
}

Constraint WeighedOdometry::constraint(const Keyframe& from, const Keyframe& to,
                                       const Eigen::Matrix3d& covariance_in_odom,
                                       const Pose2& T_local_from,
                                       const TrackedScan& tracked) const {
  Constraint constraint;
  constraint.from = from.id;
  constraint.to = to.id;
  const Pose2 motion = relativePose(from.T_odom_base, to.T_odom_base);
  const Pose2 seen = relativePose(T_local_from, tracked.belief.pose);
  constraint.T_from_to = has_jumped_ ? seen : calibration_.corrected(motion);
  Eigen::Matrix3d covariance =
      scaleFor(motion) * geometry::rotateCovariance(covariance_in_odom, -to.T_odom_base.theta);
  covariance.diagonal() +=
      Eigen::Vector3d(kFloorTranslation, kFloorTranslation, kFloorRotation).cwiseAbs2();
  if (has_jumped_) {
    covariance += nearlyNothing();
  } else if (tracked.is_trusted) {
    const Eigen::Vector3d error = relativePose(constraint.T_from_to, seen).vector();
    if (error.dot(covariance.inverse() * error) > kSlip) {
      covariance += error * error.transpose();
    }
  }
  constraint.information = covariance.inverse();
  constraint.information =
      0.5 * (constraint.information + constraint.information.transpose()).eval();
  constraint.kind = graph::ConstraintKind::kOdometry;
  return constraint;
}

void WeighedOdometry::weigh(const Keyframe& from, const Keyframe& to,
                            const Eigen::Matrix3d& covariance_in_odom, const Pose2& T_local_from,
                            const Belief& matched) {
  if (has_jumped_) {
    return;
  }
  const Pose2 motion = relativePose(from.T_odom_base, to.T_odom_base);
  const Eigen::Matrix3d covariance =
      geometry::rotateCovariance(covariance_in_odom, -from.T_odom_base.theta);
  const Belief seen{relativePose(T_local_from, matched.pose),
                    geometry::rotateCovariance(matched.covariance, -T_local_from.theta)};
  raw_scale_.note({motion, covariance}, seen);
  scale_.note({calibration_.corrected(motion), covariance}, seen);
  calibration_.note({motion, scale_.value() * covariance}, seen);
}

}  // namespace omega_slam::slam

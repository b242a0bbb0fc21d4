#include "omega_slam/motion/motion_predictor.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/covariance.h"

namespace omega_slam::motion {

using geometry::Pose2;

namespace {

// A segment ends after so much driving or turning: about a keyframe's distance, the step for which
// users know their odometry's errors.
constexpr double kSegmentTranslation = 0.5;  // [m]
constexpr double kSegmentRotation = 0.5;     // [rad]

}  // namespace

MotionPredictor::MotionPredictor(const OdometryMotionModelConfig& noise, int samples,
                                 std::uint64_t seed)
    : model_(noise), random_(seed), sample_count_(static_cast<std::size_t>(std::max(samples, 0))) {}

void MotionPredictor::anchor(const Pose2& T_odom_base) {
  anchored_ = true;
  T_odom_segment_ = T_odom_base;
  T_odom_base_ = T_odom_base;
  segment_covariance_.setZero();
  segment_samples_.assign(sample_count_, T_odom_base);
}

Prediction MotionPredictor::predict(double stamp, const Pose2& T_odom_base) {
  if (!anchored_) {
    anchor(T_odom_base);
  }
  T_odom_base_ = T_odom_base;
  const Pose2 segment = relativePose(T_odom_segment_, T_odom_base);
  if (std::hypot(segment.x, segment.y) > kSegmentTranslation ||
      std::abs(segment.theta) > kSegmentRotation) {
    closeSegment(T_odom_base);
  }
  return {stamp, T_odom_base, covarianceAt(T_odom_base)};
}

std::vector<Pose2> MotionPredictor::samples() { return samplesAt(T_odom_base_); }

void MotionPredictor::reset() { anchored_ = false; }

void MotionPredictor::closeSegment(const Pose2& T_odom_base) {
  segment_covariance_ = covarianceAt(T_odom_base);
  segment_samples_ = samplesAt(T_odom_base);
  T_odom_segment_ = T_odom_base;
}

Eigen::Matrix3d MotionPredictor::covarianceAt(const Pose2& T_odom_base) const {
  const Pose2 segment = relativePose(T_odom_segment_, T_odom_base);
  return geometry::composeCovariance(T_odom_segment_, segment_covariance_, segment,
                                     model_.covariance(segment));
}

std::vector<Pose2> MotionPredictor::samplesAt(const Pose2& T_odom_base) {
  const Pose2 segment = relativePose(T_odom_segment_, T_odom_base);
  std::vector<Pose2> moved;
  moved.reserve(segment_samples_.size());
  for (const Pose2& start : segment_samples_) {
    moved.push_back(start * model_.sample(segment, random_));
  }
  return moved;
}

}  // namespace omega_slam::motion

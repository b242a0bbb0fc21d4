#pragma once

#include <Eigen/Core>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::slam {

/// A pose and how far it may be off.
struct Belief {
  geometry::Pose2 pose;
  /// Of (x, y, theta) [m^2, m rad, rad^2], in the axes of the frame that the pose is in.
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};
};

/// `a - b` as (x, y, theta), in the axes of their frame; the angle in (-pi, pi].
[[nodiscard]] Eigen::Vector3d differenceOf(const geometry::Pose2& a, const geometry::Pose2& b);

/// Squared Mahalanobis distance between two independent beliefs of one pose: 3 on average where
/// both state truly how far they may be off.
[[nodiscard]] double squaredDistance(const Belief& a, const Belief& b);

}  // namespace omega_slam::slam

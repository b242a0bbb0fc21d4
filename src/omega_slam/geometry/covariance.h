#pragma once

#include <Eigen/Core>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::geometry {

/// Covariance of `T_a_c = T_a_b * T_b_c` from the covariances of its independent parts, to first
/// order (Smith, Self and Cheeseman 1990, section 3: the compounding operation). Each covariance is
/// of (x, y, theta) in the axes of its pose's first frame [m^2, m rad, rad^2].
[[nodiscard]] Eigen::Matrix3d composeCovariance(const Pose2& T_a_b,
                                                const Eigen::Matrix3d& covariance_a_b,
                                                const Pose2& T_b_c,
                                                const Eigen::Matrix3d& covariance_b_c);

/// The same covariance with its translation in axes turned by `angle` [rad]: from the axes of a
/// frame b to those of a frame a in which b has that heading.
[[nodiscard]] Eigen::Matrix3d rotateCovariance(const Eigen::Matrix3d& covariance, double angle);

/// Carries small motions (x, y, theta) in the frame of b to the same ones in that of a, where the
/// frames are parts of one body (the adjoint of SE(2); Sola, Deray and Atchuthan 2018, equation
/// 159).
[[nodiscard]] Eigen::Matrix3d adjoint(const Pose2& T_a_b);

/// Finite, symmetric to rounding, and no eigenvalue below zero but for rounding.
[[nodiscard]] bool isPositiveSemidefinite(const Eigen::Matrix3d& matrix);

}  // namespace omega_slam::geometry

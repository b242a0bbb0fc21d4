#include "omega_slam/geometry/covariance.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace omega_slam::geometry {

namespace {

Eigen::Matrix3d rotationOnly(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return (Eigen::Matrix3d() << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0).finished();
}

}  // namespace

Eigen::Matrix3d composeCovariance(const Pose2& T_a_b, const Eigen::Matrix3d& covariance_a_b,
                                  const Pose2& T_b_c, const Eigen::Matrix3d& covariance_b_c) {
  const Eigen::Vector2d arm = T_a_b.rotation() * T_b_c.translation();
  Eigen::Matrix3d by_first = Eigen::Matrix3d::Identity();
  by_first(0, 2) = -arm.y();
  by_first(1, 2) = arm.x();
  return by_first * covariance_a_b * by_first.transpose() +
         rotateCovariance(covariance_b_c, T_a_b.theta);
}

Eigen::Matrix3d rotateCovariance(const Eigen::Matrix3d& covariance, double angle) {
  const Eigen::Matrix3d rotation = rotationOnly(angle);
  return rotation * covariance * rotation.transpose();
}

Eigen::Matrix3d adjoint(const Pose2& T_a_b) {
  Eigen::Matrix3d result = rotationOnly(T_a_b.theta);
  result(0, 2) = T_a_b.y;
  result(1, 2) = -T_a_b.x;
  return result;
}

bool isPositiveSemidefinite(const Eigen::Matrix3d& matrix) {
  if (!matrix.allFinite()) {
    return false;
  }
  const double tolerance = 1e-9 * std::max(1.0, matrix.cwiseAbs().maxCoeff());
  if ((matrix - matrix.transpose()).cwiseAbs().maxCoeff() > tolerance) {
    return false;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() >= -tolerance;
}

}  // namespace omega_slam::geometry

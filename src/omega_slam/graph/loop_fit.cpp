#include "omega_slam/graph/loop_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/graph/linearization.h"

namespace omega_slam::graph {
namespace {

using geometry::kPi;

constexpr double kSmallestArea = 1.0;  // [m^2]
// Share of a counted loop's variance that the rest must explain, in every direction. What is less
// is rounding.
constexpr double kSmallestRedundancy = 1e-7;

Eigen::Matrix3d squareRoot(const Eigen::Matrix3d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrix);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

}  // namespace

ErrorSpace ErrorSpace::of(const std::vector<geometry::Pose2>& poses) {
  if (poses.empty()) {
    return {2.0 * kPi * kSmallestArea};
  }
  Eigen::Vector2d low = poses.front().translation();
  Eigen::Vector2d high = low;
  for (const geometry::Pose2& pose : poses) {
    low = low.cwiseMin(pose.translation());
    high = high.cwiseMax(pose.translation());
  }
  return {2.0 * kPi * std::max((high - low).prod(), kSmallestArea)};
}

double chanceOf(const LoopFit& fit, const ErrorSpace& space) {
  const double ellipsoid = 4.0 / 3.0 * kPi * std::pow(fit.squared, 1.5) * fit.spread;
  return fit.is_testable ? std::min(1.0, ellipsoid / space.volume) : 1.0;
}

double oddsOf(const LoopFit& fit, const ErrorSpace& space, double variance) {
  if (!fit.is_testable) {
    return 1.0;
  }
  const double normal = std::pow(2.0 * kPi * variance, 1.5) * fit.spread;
  return std::exp(-0.5 * fit.squared / variance) * space.volume / normal;
}

LoopFit fitOf(const Constraint& loop, const Eigen::Vector3d& error,
              const Eigen::Matrix3d& covariance, bool is_counted) {
  // In units of the loop's own standard deviations, innovations have the covariance I + S, and
  // errors at a solution that counts the loop have I - S.
  const Eigen::Matrix3d root = squareRoot(loop.information);
  const Eigen::Matrix3d predicted = root * covariance * root;
  const Eigen::Matrix3d expected =
      Eigen::Matrix3d::Identity() +
      (is_counted ? -1.0 : 1.0) * 0.5 * Eigen::Matrix3d(predicted + predicted.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(expected);
  const Eigen::Vector3d variances = eigen.eigenvalues();
  if (variances.minCoeff() < kSmallestRedundancy) {
    return {0.0, std::numeric_limits<double>::infinity(), false};
  }
  const Eigen::Vector3d whitened = eigen.eigenvectors().transpose() * (root * error);
  LoopFit fit;
  fit.squared = whitened.cwiseAbs2().cwiseQuotient(variances).sum();
  const double spread = std::sqrt(is_counted ? 1.0 / variances.prod() : variances.prod());
  fit.spread = spread / std::sqrt(loop.information.determinant());
  return fit;
}

LoopFit fitOfNewLoop(const PoseGraph& graph, const Constraint& loop,
                     const Eigen::Matrix3d& relative_covariance) {
  // The error stands in the axes of the measurement, the covariance in those of `from`.
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = loop.T_from_to.rotation().transpose();
  return fitOf(loop, errorOf(loop, graph), turn * relative_covariance * turn.transpose(), false);
}

}  // namespace omega_slam::graph

#include "experiments/determination.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/matching/surface_model.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

constexpr double kReach = 0.1;           // [m] from a point to its place on a line
constexpr double kLeastIncidence = 0.2;  // sine of the angle between beam and line
constexpr double kDeviations = 3.0;
constexpr double kLeastInformation = 1e-3;  // keeps open directions finite: a deviation of 30 m

}  // namespace

bool PoseError::isWithin(const Tolerance& tolerance) const {
  return translation <= tolerance.translation && rotation <= tolerance.rotation;
}

PoseError errorOf(const Pose2& estimate, const Pose2& truth) {
  const Pose2 gap = relativePose(truth, estimate);
  return {gap.translation().norm(), std::abs(gap.theta)};
}

Eigen::Matrix3d informationOf(const ScanPair& pair, const RangeDeviation& deviation) {
  matching::SurfaceModel model({pair.reference});
  const Eigen::Matrix2d rotation = pair.T_reference_scan.rotation();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector2d& p_scan : pair.scan.points) {
    const Eigen::Vector2d arm = rotation * p_scan;
    const auto partner = model.partnerOf(arm + pair.T_reference_scan.translation(), kReach);
    if (!partner || !partner->surface.isLine()) {
      continue;
    }
    const Eigen::Vector2d& normal = partner->surface.normal;
    const Eigen::Vector2d tangent(-normal.y(), normal.x());
    const Eigen::Vector2d beam = rotation * (p_scan - pair.scan.origin);
    const double range = beam.norm();
    const double incidence = std::max(std::abs(normal.dot(beam)) / range, kLeastIncidence);
    const double sigma = deviation(range) * incidence;
    const Eigen::Matrix2d told = normal * normal.transpose() -
                                 partner->surface.slope_variance * tangent * tangent.transpose();
    information += matching::poseInformation(told, arm) / (2.0 * sigma * sigma);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(information);
  return axes.eigenvectors() * axes.eigenvalues().cwiseMax(kLeastInformation).asDiagonal() *
         axes.eigenvectors().transpose();
}

Determination determinationOf(const ScanPair& pair, const RangeDeviation& deviation,
                              const Tolerance& tolerance) {
  const auto enough = static_cast<std::size_t>(matching::MatchConfig{}.min_returns);
  if (std::min(pair.reference.points.size(), pair.scan.points.size()) < enough) {
    return Determination::kTooFewReturns;
  }
  const Eigen::Matrix3d covariance = informationOf(pair, deviation).inverse();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(covariance.topLeftCorner<2, 2>());
  const PoseError farthest{kDeviations * std::sqrt(axes.eigenvalues()[1]),
                           kDeviations * std::sqrt(covariance(2, 2))};
  return farthest.isWithin(tolerance) ? Determination::kDetermined : Determination::kOpenDirection;
}

}  // namespace omega_slam::experiments

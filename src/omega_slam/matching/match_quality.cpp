#include "omega_slam/matching/match_quality.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "omega_slam/matching/traced_surfaces.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr double kPriorTranslation = 1.0;  // [m] deviation along directions that nothing determines
constexpr double kPriorRotation = 0.5;     // [rad]
constexpr double kFloorTranslation = 0.005;  // [m]
constexpr double kFloorRotation = 0.002;     // [rad]

/// @param deviation [m] of a range
Eigen::Matrix3d covarianceOf(const MatchEvidence& evidence, double deviation) {
  const Eigen::Vector3d prior(1.0 / (kPriorTranslation * kPriorTranslation),
                              1.0 / (kPriorTranslation * kPriorTranslation),
                              1.0 / (kPriorRotation * kPriorRotation));
  const Eigen::Vector3d floor(kFloorTranslation * kFloorTranslation,
                              kFloorTranslation * kFloorTranslation,
                              kFloorRotation * kFloorRotation);
  const double variance = kDistanceVariance * deviation * deviation;
  // Points farther away than numbers can square say nothing.
  const bool is_finite = (evidence.hessian / variance).allFinite();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(
      is_finite ? evidence.hessian : Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
  // Along an open direction doubt may leave less than nothing.
  Eigen::Matrix3d information = axes.eigenvectors() *
                                axes.eigenvalues().cwiseMax(0.0).asDiagonal() *
                                axes.eigenvectors().transpose() / variance;
  information.diagonal() += prior;
  Eigen::Matrix3d covariance = information.inverse();
  covariance = 0.5 * (covariance + covariance.transpose()).eval();
  covariance.diagonal() += floor;
  return covariance;
}

}  // namespace

void MatchEvidence::add(const Surface& surface, const Eigen::Vector2d& gap,
                        const Eigen::Vector2d& arm, const Eigen::Vector2d& facing) {
  addDistance(surface, gap);
  hessian += certainInformation(surface, arm, facing);
}

void MatchEvidence::addDistance(const Surface& surface, const Eigen::Vector2d& gap) {
  ++partners;
  if (surface.isLine()) {
    // Along a wall the spacing of its points is no error.
    const double distance = surface.normal.dot(gap);
    squared_residuals += distance * distance;
  } else {
    squared_residuals += gap.squaredNorm();
  }
}

double MatchEvidence::overlap() const {
  return static_cast<double>(partners) / static_cast<double>(points);
}

double MatchEvidence::residual() const {
  return std::sqrt(squared_residuals / static_cast<double>(partners));
}

double MatchEvidence::confidence(const MatchConfig& config) const {
  if (partners == 0) {
    return 0.0;
  }
  const double misfit = residual() / config.outlier_distance;
  return std::clamp(overlap() * (1.0 - misfit * misfit), 0.0, 1.0);
}

void nameOpenDirection(MatchResult& result) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(result.covariance);
  if (std::sqrt(axes.eigenvalues()[2]) > kOpenDeviation) {
    result.failure = MatchFailure::kDegenerate;
    result.open_direction = axes.eigenvectors().col(2);
  }
}

MatchResult judgeEvidence(const MatchEvidence& evidence, const Pose2& T_reference_scan,
                          const MatchConfig& config) {
  MatchResult result;
  result.T_reference_scan = T_reference_scan;
  if (evidence.partners == 0) {
    result.covariance = covarianceOf(evidence, config.range_noise);
    result.failure = MatchFailure::kNoOverlap;
    return result;
  }
  result.overlap = evidence.overlap();
  result.residual = evidence.residual();
  result.confidence = evidence.confidence(config);
  result.covariance = covarianceOf(evidence, std::max(config.range_noise, result.residual));
  nameOpenDirection(result);
  return result;
}

MatchResult judgeMatch(SurfaceModel& reference, const View& scan, const Pose2& T_reference_scan,
                       const MatchConfig& config) {
  const Eigen::Matrix2d rotation = T_reference_scan.rotation();
  const std::vector<SurfacePatch> patches = tracePatches(scan);
  MatchEvidence evidence;
  evidence.points = scan.points.size();
  reference.forEachPartner({scan}, T_reference_scan, config.outlier_distance,
                           [&](std::size_t point, const SurfaceModel::Partner& partner,
                               const Eigen::Vector2d& gap, const Eigen::Vector2d& arm) {
                             evidence.add(partner.surface, gap, arm,
                                          rotation * patches[point].surface.normal);
                           });
  return judgeEvidence(evidence, T_reference_scan, config);
}

double confidenceAt(SurfaceModel& reference, const SomePoints& scan, const Pose2& T_reference_scan,
                    const MatchConfig& config) {
  MatchEvidence evidence;
  evidence.points = scan.size();
  reference.forEachPartner(
      scan, T_reference_scan, config.outlier_distance,
      [&](std::size_t /*point*/, const SurfaceModel::Partner& partner, const Eigen::Vector2d& gap,
          const Eigen::Vector2d& /*arm*/) { evidence.addDistance(partner.surface, gap); });
  return evidence.confidence(config);
}

}  // namespace omega_slam::matching

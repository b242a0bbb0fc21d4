#include "omega_slam/matching/match_quality.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "omega_slam/matching/point_index.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr std::size_t kSurfaceNeighbours = 6;
constexpr double kSurfaceRadius = 0.3;     // [m] neighbours farther away belong to another surface
constexpr double kLineFlatness = 0.25;     // minor over major axis; above, it is no line
constexpr double kPriorTranslation = 1.0;  // [m] deviation along directions that nothing determines
constexpr double kPriorRotation = 0.5;     // [rad]
constexpr double kFloorTranslation = 0.01;    // [m]
constexpr double kFloorRotation = 0.003;      // [rad]
constexpr double kDegenerateDeviation = 0.3;  // [m] a direction known no better is not determined

/// Unit normal of the surface around a point's neighbours; zero where they form no line.
Eigen::Vector2d surfaceNormal(const Points& points,
                              const std::vector<PointIndex::Neighbour>& neighbours) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  int count = 0;
  for (const auto& neighbour : neighbours) {
    if (neighbour.squared_distance <= kSurfaceRadius * kSurfaceRadius) {
      mean += points[neighbour.index];
      ++count;
    }
  }
  if (count < 3) {
    return Eigen::Vector2d::Zero();
  }
  mean /= count;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const auto& neighbour : neighbours) {
    if (neighbour.squared_distance <= kSurfaceRadius * kSurfaceRadius) {
      const Eigen::Vector2d d = points[neighbour.index] - mean;
      scatter += d * d.transpose();
    }
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(scatter);
  if (axes.eigenvalues()[0] > kLineFlatness * kLineFlatness * axes.eigenvalues()[1]) {
    return Eigen::Vector2d::Zero();
  }
  return axes.eigenvectors().col(0);
}

struct Evidence {
  std::size_t partners{0};
  double squared_residuals{0.0};
  Eigen::Matrix3d hessian{Eigen::Matrix3d::Zero()};  // sum of J^T J
};

Evidence gatherEvidence(const Points& reference, const Points& scan, const Pose2& T_reference_scan,
                        double outlier_distance) {
  const PointIndex index(reference);
  const Eigen::Matrix2d rotation = T_reference_scan.rotation();
  std::vector<PointIndex::Neighbour> nearest;
  std::vector<PointIndex::Neighbour> surface;
  Evidence evidence;
  for (const Eigen::Vector2d& p_scan : scan) {
    const Eigen::Vector2d arm = rotation * p_scan;
    const Eigen::Vector2d p_reference = arm + T_reference_scan.translation();
    index.nearest(p_reference, 1, nearest);
    if (nearest.empty() || nearest.front().squared_distance > outlier_distance * outlier_distance) {
      continue;
    }
    index.nearest(reference[nearest.front().index], kSurfaceNeighbours, surface);
    const Eigen::Vector2d normal = surfaceNormal(reference, surface);
    const Eigen::Vector2d gap = p_reference - reference[nearest.front().index];
    // Along a wall the spacing of its points is no error.
    const double residual = normal.isZero() ? gap.norm() : normal.dot(gap);
    const Eigen::Vector3d jacobian(normal.x(), normal.y(),
                                   normal.y() * arm.x() - normal.x() * arm.y());
    evidence.hessian += jacobian * jacobian.transpose();
    evidence.squared_residuals += residual * residual;
    ++evidence.partners;
  }
  return evidence;
}

Eigen::Matrix3d covarianceOf(const Evidence& evidence, double deviation) {
  const Eigen::Vector3d prior(1.0 / (kPriorTranslation * kPriorTranslation),
                              1.0 / (kPriorTranslation * kPriorTranslation),
                              1.0 / (kPriorRotation * kPriorRotation));
  const Eigen::Vector3d floor(kFloorTranslation * kFloorTranslation,
                              kFloorTranslation * kFloorTranslation,
                              kFloorRotation * kFloorRotation);
  Eigen::Matrix3d information = evidence.hessian / (deviation * deviation);
  information.diagonal() += prior;
  Eigen::Matrix3d covariance = information.inverse();
  covariance = 0.5 * (covariance + covariance.transpose()).eval();
  covariance.diagonal() += floor;
  return covariance;
}

}  // namespace

MatchResult judgeMatch(const Points& reference, const Points& scan, const Pose2& T_reference_scan,
                       const MatchQualityConfig& config) {
  MatchResult result;
  result.T_reference_scan = T_reference_scan;
  const Evidence evidence =
      gatherEvidence(reference, scan, T_reference_scan, config.outlier_distance);
  if (evidence.partners == 0) {
    result.covariance = covarianceOf(evidence, config.range_noise);
    result.failure = MatchFailure::kNoOverlap;
    return result;
  }
  const auto partners = static_cast<double>(evidence.partners);
  result.overlap = partners / static_cast<double>(scan.size());
  result.residual = std::sqrt(evidence.squared_residuals / partners);
  const double misfit = result.residual / config.outlier_distance;
  result.confidence = std::clamp(result.overlap * (1.0 - misfit * misfit), 0.0, 1.0);
  result.covariance = covarianceOf(evidence, std::max(config.range_noise, result.residual));
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(result.covariance.topLeftCorner<2, 2>());
  if (std::sqrt(axes.eigenvalues()[1]) > kDegenerateDeviation) {
    result.failure = MatchFailure::kDegenerate;
  }
  return result;
}

}  // namespace omega_slam::matching

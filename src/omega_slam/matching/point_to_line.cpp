#include "omega_slam/matching/point_to_line.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "omega_slam/matching/match_quality.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr double kTolerance = 2.0;      // in standard deviations of a range
constexpr double kSmallestStep = 1e-5;  // [m], [rad]
constexpr double kStiffness = 1e4;      // of what holds open directions, over all that pulls

}  // namespace

void PointToLineEquations::add(const Surface& surface, const Eigen::Vector2d& gap,
                               const Eigen::Vector2d& arm, const DistanceKernel& kernel) {
  if (surface.isLine()) {
    const Eigen::Vector3d across = byPose(surface.normal, arm);
    const Eigen::Vector3d along = byPose({-surface.normal.y(), surface.normal.x()}, arm);
    const double distance = surface.normal.dot(gap);
    const double weight = kernel.weightAt(distance * distance);
    const Eigen::Vector3d weighted = weight * across;
    const Eigen::Matrix3d known = weighted * across.transpose();
    matrix += known;
    vector -= distance * weighted;
    certain += known - (weight * surface.doubt()) * along * along.transpose();
    return;
  }
  // The partner itself, half in each direction.
  const double weight = 0.5 * kernel.weightAt(0.5 * gap.squaredNorm());
  const Eigen::Matrix3d known = weight * poseInformation(Eigen::Matrix2d::Identity(), arm);
  matrix += known;
  vector -= weight * byPose(gap, arm);
  if (surface.is_spot) {
    certain += known;
  }
}

PointToLineEquations linearize(SurfaceModel& reference, const SomePoints& scan,
                               const Pose2& T_reference_scan, const DistanceKernel& kernel) {
  PointToLineEquations equations;
  reference.forEachPartner(
      scan, T_reference_scan, kernel.reach,
      [&](std::size_t /*point*/, const SurfaceModel::Partner& partner, const Eigen::Vector2d& gap,
          const Eigen::Vector2d& arm) { equations.add(partner.surface, gap, arm, kernel); });
  return equations;
}

Eigen::Vector3d stepToLeastSquares(const PointToLineEquations& equations, const Pose2& pose,
                                   const Pose2& guess) {
  constexpr double kOpenInformation = kDistanceVariance / (kOpenDeviation * kOpenDeviation);
  const double stiff = 1.0 + kStiffness * equations.matrix.trace();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(equations.certain);
  const Eigen::Vector3d way_back(guess.x - pose.x, guess.y - pose.y,
                                 relativePose(pose, guess).theta);
  Eigen::Matrix3d hold = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    if (axes.eigenvalues()[i] < kOpenInformation) {
      hold += stiff * axes.eigenvectors().col(i) * axes.eigenvectors().col(i).transpose();
    }
  }
  const Eigen::Vector3d step =
      (equations.matrix + hold).ldlt().solve(equations.vector + hold * way_back);
  return step.allFinite() ? step : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

Pose2 refinePointToLine(SurfaceModel& reference, const View& scan, const Pose2& guess,
                        const PointToLineConfig& config) {
  const DistanceKernel kernel{config.reach, config.range_noise, kTolerance * config.range_noise};
  Pose2 pose = guess;
  for (int i = 0; i < config.max_iterations; ++i) {
    const Eigen::Vector3d step =
        stepToLeastSquares(linearize(reference, scan, pose, kernel), pose, guess);
    pose = Pose2::fromVector(pose.vector() + step);
    if (step.cwiseAbs().maxCoeff() < kSmallestStep) {
      break;
    }
  }
  return pose;
}

}  // namespace omega_slam::matching

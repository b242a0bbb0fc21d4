#include "omega_slam/matching/point_to_line.h"

#include <Eigen/Cholesky>

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr double kPriorDeviation = 0.05;  // [m], [rad] of the guess
constexpr double kCauchy = 2.0;         // in standard deviations of a range: half the weight there
constexpr double kSmallestStep = 1e-5;  // [m], [rad]

struct NormalEquations {
  Eigen::Matrix3d matrix{Eigen::Matrix3d::Zero()};
  Eigen::Vector3d vector{Eigen::Vector3d::Zero()};
};

/// J^T W J and -J^T W r of all distances at a pose, in units of a range's variance.
NormalEquations linearize(SurfaceModel& reference, const Points& scan, const Pose2& pose,
                          const PointToLineConfig& config) {
  const Eigen::Matrix2d rotation = pose.rotation();
  NormalEquations equations;
  for (const Eigen::Vector2d& p_scan : scan) {
    const Eigen::Vector2d arm = rotation * p_scan;
    const Eigen::Vector2d p_reference = arm + pose.translation();
    const auto partner = reference.partnerOf(p_reference, config.reach);
    if (!partner || !partner->surface.isLine()) {
      continue;
    }
    const Eigen::Vector2d& normal = partner->surface.normal;
    const double distance = normal.dot(p_reference - partner->point) / config.range_noise;
    const double weight = 1.0 / (1.0 + distance * distance / (kCauchy * kCauchy));
    const Eigen::Vector3d jacobian =
        Eigen::Vector3d(normal.x(), normal.y(), normal.y() * arm.x() - normal.x() * arm.y()) /
        config.range_noise;
    equations.matrix += weight * jacobian * jacobian.transpose();
    equations.vector -= weight * distance * jacobian;
  }
  return equations;
}

}  // namespace

Pose2 refinePointToLine(SurfaceModel& reference, const Points& scan, const Pose2& guess,
                        const PointToLineConfig& config) {
  constexpr double kPrior = 1.0 / (kPriorDeviation * kPriorDeviation);
  Pose2 pose = guess;
  for (int i = 0; i < config.max_iterations; ++i) {
    NormalEquations equations = linearize(reference, scan, pose, config);
    equations.matrix.diagonal().array() += kPrior;
    equations.vector[0] -= kPrior * (pose.x - guess.x);
    equations.vector[1] -= kPrior * (pose.y - guess.y);
    equations.vector[2] -= kPrior * relativePose(guess, pose).theta;
    const Eigen::Vector3d step = equations.matrix.ldlt().solve(equations.vector);
    if (!step.allFinite()) {
      return guess;
    }
    pose = Pose2::fromVector(pose.vector() + step);
    if (step.cwiseAbs().maxCoeff() < kSmallestStep) {
      break;
    }
  }
  return pose;
}

}  // namespace omega_slam::matching

#include "experiments/consistency.h"

#include <gtest/gtest.h>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::experiments {
namespace {

using geometry::Pose2;

matching::MatchResult found(const Pose2& pose, const Eigen::Vector3d& deviations) {
  matching::MatchResult result;
  result.T_reference_scan = pose;
  result.covariance = deviations.cwiseAbs2().asDiagonal();
  return result;
}

TEST(SquaredMahalanobis, CountsDeviations) {
  const Eigen::Vector3d deviations(0.1, 0.2, 0.01);
  const Pose2 truth{1.0, 2.0, 3.14};
  EXPECT_EQ(squaredMahalanobis(found(truth, deviations), truth), 0.0);
  const Pose2 off{1.1, 1.8, geometry::normalizeAngle(3.14 + 0.02)};
  EXPECT_NEAR(squaredMahalanobis(found(off, deviations), truth), 1.0 + 1.0 + 4.0, 1e-9)
      << "across the seam of angles";
}

TEST(SquaredMahalanobis, OpenDirectionsForgive) {
  const Pose2 off{1.0, 0.0, 0.0};
  EXPECT_GT(squaredMahalanobis(found(off, {0.01, 0.01, 0.01}), {}), kThreeSigma);
  EXPECT_LT(squaredMahalanobis(found(off, {1.0, 0.01, 0.01}), {}), kThreeSigma);
}

/// Of a normal error with the claimed covariance, 99.73 % lie inside.
TEST(SquaredMahalanobis, ThreeSigmaHoldsWhatItSays) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const Eigen::Vector3d deviations(0.02, 0.03, 0.01);
  const int draws = 100000;
  int inside = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = deviations[0] * normal(random);
    const double y = deviations[1] * normal(random);
    const double theta = deviations[2] * normal(random);
    inside += squaredMahalanobis(found({x, y, theta}, deviations), {}) <= kThreeSigma ? 1 : 0;
  }
  EXPECT_NEAR(inside / static_cast<double>(draws), 0.9973, 0.0007);
}

}  // namespace
}  // namespace omega_slam::experiments

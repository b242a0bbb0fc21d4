#include "omega_slam/geometry/pose2.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/covariance.h"
#include "support/poses.h"
#include "support/seeds.h"

namespace omega_slam::geometry {
namespace {

constexpr double kTiny = 1e-9;

void expectSame(const Pose2& a, const Pose2& b) {
  const test::PoseGap gap = test::gapBetween(a, b);
  EXPECT_LT(gap.translation, kTiny);
  EXPECT_LT(gap.rotation, kTiny);
}

/// The places where formulas break: identity, next to it, at +-pi, and anywhere.
std::vector<Pose2> interestingPoses(std::mt19937_64& random) {
  std::vector<Pose2> poses = {{}, {1e-8, -1e-8, 1e-8}, {1.0, 2.0, kPi}, {1.0, 2.0, -kPi}};
  for (int i = 0; i < 50; ++i) {
    poses.push_back(test::randomPose(100.0, 3.2, random));
  }
  return poses;
}

TEST(Pose2Laws, HoldEverywhere) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const auto poses = interestingPoses(random);
    for (std::size_t i = 0; i + 2 < poses.size(); ++i) {
      const Pose2 &a = poses[i], &b = poses[i + 1], &c = poses[i + 2];
      expectSame((a * b) * c, a * (b * c));
      expectSame(a * a.inverse(), {});
      expectSame(a.inverse() * a, {});
      expectSame(a * Pose2{}, a);
      expectSame((a * b).inverse(), b.inverse() * a.inverse());
      expectSame(a * relativePose(a, b), b);
      const Eigen::Vector2d p(0.3, -4.0);
      EXPECT_LT(((a * b) * p - a * (b * p)).norm(), kTiny);
      EXPECT_LT((a * p - (a.rotation() * p + a.translation())).norm(), kTiny);
      EXPECT_LT((a * b).theta, kPi);
      EXPECT_GE((a * b).theta, -kPi);
    }
  }
}

TEST(Pose2Laws, InterpolationMeetsItsEndsAndTakesTheShortArc) {
  const Pose2 start{0.0, 0.0, 3.0};
  const Pose2 end{2.0, 4.0, -3.0};
  expectSame(interpolate(start, end, 0.0), start);
  expectSame(interpolate(start, end, 1.0), end);
  EXPECT_NEAR(std::abs(interpolate(start, end, 0.5).theta), kPi, 1e-9);
}

TEST(CovarianceLaws, CompositionAgreesWithDrawnPoses) {
  std::mt19937_64 random(5);
  const Pose2 T_a_b{1.0, 2.0, 0.7};
  const Pose2 T_b_c{3.0, -1.0, -0.4};
  const Eigen::Vector3d deviation(0.02, 0.01, 0.02);
  const Eigen::Matrix3d covariance = deviation.cwiseAbs2().asDiagonal();
  const Eigen::Matrix3d predicted = composeCovariance(T_a_b, covariance, T_b_c, covariance);

  // Errors stand in the axes of the first frame of each pose.
  std::normal_distribution<double> normal;
  const auto disturbed = [&](const Pose2& pose) {
    const Eigen::Vector3d error(normal(random), normal(random), normal(random));
    return Pose2::fromVector(pose.vector() + error.cwiseProduct(deviation));
  };
  constexpr int kDraws = 40000;
  Eigen::Matrix3d drawn = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector3d e =
        (disturbed(T_a_b) * disturbed(T_b_c)).vector() - (T_a_b * T_b_c).vector();
    drawn += e * e.transpose() / kDraws;
  }
  // A sample variance of 40,000 draws strays by 0.7 percent (one sigma).
  EXPECT_LT((drawn - predicted).norm(), 0.04 * predicted.norm());
}

TEST(CovarianceLaws, SemidefiniteIsRecognised) {
  EXPECT_TRUE(isPositiveSemidefinite(Eigen::Matrix3d::Identity()));
  EXPECT_TRUE(isPositiveSemidefinite(Eigen::Matrix3d::Zero()));
  Eigen::Matrix3d negative = Eigen::Matrix3d::Identity();
  negative(2, 2) = -1.0;
  EXPECT_FALSE(isPositiveSemidefinite(negative));
  Eigen::Matrix3d skew = Eigen::Matrix3d::Identity();
  skew(0, 1) = 0.5;
  EXPECT_FALSE(isPositiveSemidefinite(skew));
  skew(0, 1) = std::nan("");
  EXPECT_FALSE(isPositiveSemidefinite(skew));
}

}  // namespace
}  // namespace omega_slam::geometry

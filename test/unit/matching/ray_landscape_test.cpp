#include "omega_slam/matching/ray_landscape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/room.h"

namespace omega_slam::matching {
namespace {

constexpr double kCap = 0.3;  // [m]
const geometry::Pose2 kPose{0.1, 0.05, 0.02};

View noisyRoom() {
  std::mt19937_64 random(1);
  return {test::measurePoints(test::furnishedRoom(), {}, 683, 0.02, random)};
}

TEST(RayLandscapeTest, ShortStepsAreJudgedByTheWholeScan) {
  const Reference reference{noisyRoom()};
  const View scan = noisyRoom();
  const double error_of_all = RayReference(reference, kCap).squaredError(RayScan(scan), kPose);
  RayLandscape landscape(reference, scan, kCap);
  EXPECT_FALSE(landscape.setStep(0.1));
  EXPECT_NE(landscape.error(kPose), error_of_all);
  EXPECT_NEAR(landscape.error(kPose), error_of_all, 0.2 * error_of_all);
  EXPECT_TRUE(landscape.setStep(0.001));
  EXPECT_EQ(landscape.error(kPose), error_of_all);
  EXPECT_FALSE(landscape.setStep(0.0005)) << "nothing new";
}

TEST(RayLandscapeTest, SaysWhetherASearchHasConverged) {
  const Reference reference{noisyRoom()};
  const View scan = noisyRoom();
  const RayLandscape landscape(reference, scan, kCap);
  EXPECT_EQ(landscape.judge({}, true, {}).failure, MatchFailure::kNone);
  EXPECT_TRUE(landscape.judge({}, true, {}).converged);
  EXPECT_EQ(landscape.judge({}, false, {}).failure, MatchFailure::kNotConverged);
  EXPECT_EQ(landscape.judge({9.0, 9.0, 0.0}, false, {}).failure, MatchFailure::kNoOverlap)
      << "the worse failure counts";
}

TEST(RayLandscapeTest, PoseBesideTheBestIsDoubted) {
  const Reference reference{noisyRoom()};
  const View scan = noisyRoom();
  const RayLandscape landscape(reference, scan, kCap);
  const Eigen::Matrix3d at_best = landscape.judge({}, true, {}).covariance;
  EXPECT_LT(std::sqrt(at_best(0, 0)), 0.01);
  const Eigen::Matrix3d beside = landscape.judge({0.06, 0.0, 0.0}, true, {}).covariance;
  EXPECT_NEAR(std::sqrt(beside(0, 0)), 0.06, 0.015);
  EXPECT_LT(std::sqrt(beside(1, 1)), 0.02);
}

TEST(RayLandscapeTest, PoseThatIsNotFiniteIsRefused) {
  const Reference reference{noisyRoom()};
  const View scan = noisyRoom();
  const auto result = RayLandscape(reference, scan, kCap).judge({INFINITY, 0.0, 0.0}, true, {});
  EXPECT_TRUE(result.T_reference_scan.isFinite());
  EXPECT_EQ(result.failure, MatchFailure::kNoOverlap);
  EXPECT_FALSE(result.converged);
}

}  // namespace
}  // namespace omega_slam::matching

// Maps laid on each other: what was moved is found, whatever its pose.

#include <gtest/gtest.h>

#include <random>

#include "omega_slam/evaluation/feature_alignment.h"
#include "omega_slam/evaluation/map_correlation.h"
#include "omega_slam/evaluation/resemblance.h"
#include "omega_slam/evaluation/rigid_fit.h"
#include "omega_slam/geometry/angle.h"
#include "support/buildings.h"
#include "support/poses.h"
#include "support/seeds.h"

namespace omega_slam::evaluation {
namespace {

using geometry::Pose2;

TEST(MapAlignment, CorrelationFindsAMovedMap) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const grid::OccupancyGrid truth = test::randomBuilding(random);
    const Pose2 T_map_truth = test::randomPose(20.0, geometry::kPi, random);
    const auto found = alignByCorrelation(test::seenFrom(truth, T_map_truth), truth);
    ASSERT_TRUE(found);
    const auto gap = test::gapBetween(T_map_truth.inverse(), found->T_truth_map);
    // The middle of the building is what is laid in place; its frame's origin is metres away.
    EXPECT_LT(gap.translation, 0.1);
    EXPECT_LT(gap.rotation, 0.003);
  }
}

/// Thirty seeds: within 1.2 cells and 0.6 degrees.
TEST(MapAlignment, ControlPointsFindAMovedMap) {
  if (!hasControlPoints()) {
    GTEST_SKIP() << "SIFT is not in this OpenCV";
  }
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const grid::OccupancyGrid truth = test::randomBuilding(random);
    const Pose2 T_map_truth = test::randomPose(20.0, geometry::kPi, random);
    const FeatureAlignment found = alignByFeatures(test::seenFrom(truth, T_map_truth), truth);
    ASSERT_TRUE(found.T_truth_map) << found.reason;
    EXPECT_LE(found.inliers, found.matches);
    const Eigen::Vector2d middle(4.0, 5.5);
    const Eigen::Vector2d place = *found.T_truth_map * (T_map_truth * middle);
    EXPECT_LT((place - middle).norm(), 0.1);
  }
}

TEST(MapAlignment, TheSameMapsGiveTheSameAlignment) {
  std::mt19937_64 random(1);
  const grid::OccupancyGrid truth = test::randomBuilding(random);
  const grid::OccupancyGrid built = test::seenFrom(truth, {1.0, 2.0, 0.5});
  const auto correlation = alignByCorrelation(built, truth);
  EXPECT_EQ(correlation->T_truth_map.vector(),
            alignByCorrelation(built, truth)->T_truth_map.vector());
  if (hasControlPoints()) {
    EXPECT_EQ(alignByFeatures(built, truth).T_truth_map->vector(),
              alignByFeatures(built, truth).T_truth_map->vector());
  }
}

/// Two buildings that have nothing in common: an answer all the same, and a low figure.
TEST(MapAlignment, CorrelationAlwaysAnswers) {
  std::mt19937_64 random(1);
  const grid::OccupancyGrid truth = test::randomBuilding(random);
  const grid::OccupancyGrid other =
      test::seenFrom(test::randomBuilding(random), test::randomPose(5.0, geometry::kPi, random));
  const auto found = alignByCorrelation(other, truth);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->T_truth_map.isFinite());
  const Resemblance forced = compareMaps(other, truth, {found->T_truth_map, std::nullopt});
  EXPECT_LT(forced.wallPrecision(), 0.8);
}

/// No motion near the fit has a smaller sum of squares.
TEST(RigidFit, IsTheBest) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0.0, 0.2);
    const Pose2 truth = test::randomPose(10.0, geometry::kPi, random);
    std::vector<PointPair> pairs;
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector2d p = test::randomPose(5.0, 0.0, random).translation();
      const double dx = noise(random);
      const double dy = noise(random);
      pairs.push_back({p, truth * p + Eigen::Vector2d(dx, dy)});
    }
    const auto cost = [&pairs](const Pose2& motion) {
      double sum = 0.0;
      for (const PointPair& pair : pairs) {
        sum += (motion * pair.p_a - pair.p_b).squaredNorm();
      }
      return sum;
    };
    const Pose2 fit = fitRigidMotion(pairs);
    EXPECT_LT(test::gapBetween(truth, fit).translation, 0.5);
    for (int k = 0; k < 100; ++k) {
      EXPECT_GE(cost(fit * test::randomPose(0.1, 0.05, random)), cost(fit));
    }
  }
}

}  // namespace
}  // namespace omega_slam::evaluation

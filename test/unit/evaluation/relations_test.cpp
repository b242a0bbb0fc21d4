#include "omega_slam/evaluation/relations.h"

#include <gtest/gtest.h>

#include <cmath>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::evaluation {
namespace {

using geometry::kPi;
using geometry::Trajectory;

// Straight along x at 1 m/s, then a turn to the left on the spot, then along y.
const Trajectory kDrive{
    {0.0, {0, 0, 0}}, {1.0, {1, 0, 0}}, {2.0, {1, 0, kPi / 2}}, {3.0, {1, 1, kPi / 2}}};

TEST(Relations, NoErrorWhereTheRelationHolds) {
  const RelationsScore score = scoreRelations(kDrive, {{0.0, 3.0, {1, 1, kPi / 2}}});
  EXPECT_EQ(score.covered, 1U);
  EXPECT_NEAR(score.translation.mean, 0.0, 1e-12);
  EXPECT_NEAR(score.rotation.mean, 0.0, 1e-12);
}

TEST(Relations, MeansAndDeviationsByHand) {
  // Errors: 3 m and 4 m crosswise make 5 m; then 1 m and 0.5 rad.
  const RelationsScore score =
      scoreRelations(kDrive, {{0.0, 1.0, {4, 4, 0}}, {2.0, 3.0, {2, 0, -0.5}}});
  EXPECT_EQ(score.relations, 2U);
  EXPECT_NEAR(score.translation.mean, 3.0, 1e-12);
  EXPECT_NEAR(score.translation.deviation, 2.0, 1e-12);
  EXPECT_NEAR(score.translation.mean_square, 13.0, 1e-12);
  EXPECT_NEAR(score.translation.square_deviation, 12.0, 1e-12);
  EXPECT_NEAR(score.translation.max, 5.0, 1e-12);
  EXPECT_NEAR(score.translation.rms(), std::sqrt(13.0), 1e-12);
  EXPECT_NEAR(score.rotation.mean, 0.25, 1e-12);
  EXPECT_NEAR(score.rotation.max, 0.5, 1e-12);
}

TEST(Relations, RotationTakesTheShortWay) {
  const Trajectory turn{{0.0, {0, 0, 3.0}}, {1.0, {0, 0, -3.0}}};
  const RelationsScore score = scoreRelations(turn, {{0.0, 1.0, {0, 0, 0}}});
  EXPECT_NEAR(score.rotation.mean, 2 * kPi - 6.0, 1e-12);
}

TEST(Relations, TheNearestPoseServesWithinTheTolerance) {
  // 1.09 s takes the pose at 1 s, 1.5 s lies between two.
  EXPECT_NEAR(scoreRelations(kDrive, {{0.0, 1.09, {1, 0, 0}}}).rotation.mean, 0.0, 1e-12);
  EXPECT_NEAR(scoreRelations(kDrive, {{0.0, 1.5, {1, 0, kPi / 4}}}).rotation.mean, 0.0, 1e-12);
  RelationsOptions exact;
  exact.tolerance = 0.0;
  EXPECT_NEAR(scoreRelations(kDrive, {{0.0, 0.95, {0.95, 0, 0}}}, {}, exact).translation.mean, 0.0,
              1e-12);
}

TEST(Relations, OdometryFillsGapsBetter) {
  // The robot waits until 0.9 s and then makes the whole metre; the odometry drifts by a constant.
  const Trajectory wheels{
      {0.0, {5, 5, 1}}, {0.4, {5, 5, 1}}, {0.5, {5, 5, 1}}, {1.0, {6, 5, 1}}, {2.0, {7, 5, 1}}};
  const std::vector<graph::Relation> waiting{{0.0, 0.4, {0, 0, 0}}};
  EXPECT_NEAR(scoreRelations(kDrive, waiting).translation.mean, 0.4, 1e-12);
  EXPECT_NEAR(scoreRelations(kDrive, waiting, wheels).translation.mean, 0.0, 1e-12);
}

TEST(Relations, WhatIsNotCoveredIsCounted) {
  const std::vector<graph::Relation> relations{
      {-0.5, 1.0, {1, 0, 0}}, {0.0, 3.5, {1, 0, 0}}, {0.0, 1.0, {1, 0, 0}}};
  const RelationsScore score = scoreRelations(kDrive, relations);
  EXPECT_EQ(score.relations, 3U);
  EXPECT_EQ(score.covered, 1U);
  EXPECT_NEAR(score.translation.max, 0.0, 1e-12);
  const Trajectory gap{{0.0, {0, 0, 0}}, {10.0, {10, 0, 0}}};
  EXPECT_EQ(scoreRelations(gap, {{0.0, 5.0, {5, 0, 0}}}).covered, 0U);
  EXPECT_EQ(scoreRelations(gap, {{0.0, 1.9, {1.9, 0, 0}}}).covered, 1U);
}

TEST(Relations, NothingGivenNothingCovered) {
  EXPECT_EQ(scoreRelations({}, {{0.0, 1.0, {}}}).covered, 0U);
  EXPECT_EQ(scoreRelations({}, {{0.0, 1.0, {}}}).translation.mean, 0.0);
  EXPECT_EQ(scoreRelations(kDrive, {}).relations, 0U);
}

TEST(Relations, OrderOfTimeDoesNotMatter) {
  const Trajectory shuffled{kDrive[2], kDrive[0], kDrive[3], kDrive[1]};
  EXPECT_NEAR(scoreRelations(shuffled, {{0.0, 3.0, {1, 1, kPi / 2}}}).translation.mean, 0.0, 1e-12);
}

}  // namespace
}  // namespace omega_slam::evaluation

#include "omega_slam/matching/hill_climbing_matcher.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/poses.h"
#include "support/room.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

View seenFrom(const test::Room& room, const Pose2& T_room_laser) {
  std::mt19937_64 random(1);
  return {test::measurePoints(room, T_room_laser, 360, 0.01, random)};
}

View roomSeenFrom(const Pose2& T_room_laser) {
  return seenFrom(test::furnishedRoom(), T_room_laser);
}

void expectNear(const Pose2& found, const Pose2& truth) {
  const auto gap = test::gapBetween(found, truth);
  EXPECT_LT(gap.translation, 0.03);
  EXPECT_LT(gap.rotation, 0.01);
}

TEST(HillClimbingMatcher, FindsAPlaceFarFromTheGuess) {
  const Pose2 truth{0.5, -0.4, 0.6};
  const auto result = HillClimbingMatcher().match({roomSeenFrom({})}, roomSeenFrom(truth), {});
  expectNear(result.T_reference_scan, truth);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.failure, MatchFailure::kNone);
  EXPECT_GT(result.confidence, 0.8);
  EXPECT_LT(std::sqrt(result.covariance(0, 0)), 0.05);
}

TEST(HillClimbingMatcher, FindsTheDirectionFromNoMovement) {
  for (const Pose2& truth : {Pose2{0.0, 0.3, 0.0}, Pose2{0.0, -0.3, 0.0}}) {
    const auto result = HillClimbingMatcher().match({roomSeenFrom({})}, roomSeenFrom(truth), {});
    expectNear(result.T_reference_scan, truth);
  }
}

TEST(HillClimbingMatcher, ClimbsBeyondItsReachWhileItGetsBetter) {
  HillClimbingConfig config;
  config.distance_reach = 0.0;  // the least there is: two steps of 0.15 m
  config.shrink = 0.5;
  const Pose2 truth{0.7, 0.0, 0.0};
  const HillClimbingMatcher matcher(config);
  expectNear(matcher.match({roomSeenFrom({})}, roomSeenFrom(truth), {}).T_reference_scan, truth);
}

TEST(HillClimbingMatcher, SaysThatItHasNotConverged) {
  HillClimbingConfig config;
  config.rounds = 2;
  const HillClimbingMatcher matcher(config);
  const auto result = matcher.match({roomSeenFrom({})}, roomSeenFrom({0.1, 0.1, 0.1}), {});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.failure, MatchFailure::kNotConverged);
}

TEST(HillClimbingMatcher, CorridorIsDegenerate) {
  const View corridor = seenFrom(test::endlessCorridor(), {});
  const auto result = HillClimbingMatcher().match({corridor}, corridor, {0.0, 0.1, 0.1});
  EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
  ASSERT_TRUE(result.open_direction);
  EXPECT_GT(std::abs(result.open_direction->x()), 0.99);
}

TEST(HillClimbingMatcher, OlderViewsHelpWhereTheNewestSeesNothing) {
  const View whole = roomSeenFrom({});
  View corner;  // of which a tenth of the scan has anything in common
  for (std::size_t i = 0; i < whole.points.size() / 10; ++i) {
    corner.points.push_back(whole.points[i]);
  }
  const Pose2 T_newest_older{-0.6, 0.2, 0.3};
  const View older = transformed(T_newest_older, roomSeenFrom(T_newest_older));
  const Pose2 truth{0.1, -0.1, 0.1};
  const auto result = HillClimbingMatcher().match({older, corner}, roomSeenFrom(truth), {});
  expectNear(result.T_reference_scan, truth);
}

}  // namespace
}  // namespace omega_slam::matching

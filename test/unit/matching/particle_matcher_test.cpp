#include "omega_slam/matching/particle_matcher.h"

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

TEST(ParticleMatcher, FindsAPlaceFarFromTheGuess) {
  const Pose2 truth{0.5, -0.4, 0.6};
  const auto result = ParticleMatcher().match({roomSeenFrom({})}, roomSeenFrom(truth), {});
  expectNear(result.T_reference_scan, truth);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.failure, MatchFailure::kNone);
  EXPECT_GT(result.confidence, 0.8);
  EXPECT_LT(std::sqrt(result.covariance(0, 0)), 0.05);
}

TEST(ParticleMatcher, SaysThatItHasNotConverged) {
  ParticleConfig config;
  config.rounds = 2;
  const ParticleMatcher matcher(config);
  const auto result = matcher.match({roomSeenFrom({})}, roomSeenFrom({0.1, 0.1, 0.1}), {});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.failure, MatchFailure::kNotConverged);
}

TEST(ParticleMatcher, CorridorIsDegenerate) {
  const View corridor = seenFrom(test::endlessCorridor(), {});
  const auto result = ParticleMatcher().match({corridor}, corridor, {0.0, 0.1, 0.1});
  EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
  ASSERT_TRUE(result.open_direction);
  EXPECT_GT(std::abs(result.open_direction->x()), 0.99);
}

TEST(ParticleMatcher, OlderViewsHelpWhereTheNewestSeesNothing) {
  const View whole = roomSeenFrom({});
  View corner;  // of which a tenth of the scan has anything in common
  for (std::size_t i = 0; i < whole.points.size() / 10; ++i) {
    corner.points.push_back(whole.points[i]);
  }
  const Pose2 T_newest_older{-0.6, 0.2, 0.3};
  const View older = transformed(T_newest_older, roomSeenFrom(T_newest_older));
  const Pose2 truth{0.1, -0.1, 0.1};
  const auto result = ParticleMatcher().match({older, corner}, roomSeenFrom(truth), {});
  expectNear(result.T_reference_scan, truth);
}

TEST(ParticleMatcher, FindsThePlaceInEitherSpace) {
  const Pose2 truth{0.2, -0.1, 0.2};
  for (const auto* space : {"odometry", "cartesian"}) {
    ParticleConfig config;
    config.space = space;
    SCOPED_TRACE(space);
    const ParticleMatcher matcher(config);
    expectNear(
        matcher.match({roomSeenFrom({})}, roomSeenFrom(truth), {0.1, 0.0, 0.0}).T_reference_scan,
        truth);
  }
}

TEST(ParticleMatcher, SameCallSameResult) {
  const View reference = roomSeenFrom({});
  const View scan = roomSeenFrom({0.1, 0.1, 0.1});
  const ParticleMatcher matcher;
  const Pose2 first = matcher.match({reference}, scan, {}).T_reference_scan;
  (void)matcher.match({scan}, reference, {});
  EXPECT_EQ(matcher.match({reference}, scan, {}).T_reference_scan.vector(), first.vector());
  ParticleConfig config;
  config.seed = 2;
  const Pose2 other = ParticleMatcher(config).match({reference}, scan, {}).T_reference_scan;
  EXPECT_NE(other.vector(), first.vector()) << "the seed is of no use";
  expectNear(other, first);
}

TEST(ParticleMatcher, NearReturnsAreCountedFromTheLaser) {
  const Pose2 T_base_laser{4.0, 0.0, 0.0};  // so that a wall runs by the base
  const View room = transformed(T_base_laser, roomSeenFrom({}));
  ParticleConfig config;
  config.near_range = 1.0;
  config.max_near_share = 0.0;
  const View reference = roomSeenFrom({});
  const auto result = ParticleMatcher(config).match({reference}, room, T_base_laser.inverse());
  EXPECT_EQ(result.failure, MatchFailure::kNone);
  config.near_range = 3.5;
  EXPECT_EQ(ParticleMatcher(config).match({reference}, room, {}).failure,
            MatchFailure::kTooManyNear);
}

}  // namespace
}  // namespace omega_slam::matching

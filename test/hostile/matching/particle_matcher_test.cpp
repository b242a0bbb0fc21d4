#include "omega_slam/matching/particle_matcher.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/match_results.h"
#include "support/room.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

View roomSeenFrom(const Pose2& pose) {
  std::mt19937_64 random(1);
  return {test::measurePoints(test::furnishedRoom(), pose, 180, 0.01, random)};
}

TEST(ParticleMatcherHostile, CoveredLaserIsRefused) {
  const View room = roomSeenFrom({});
  View covered = room;
  for (std::size_t i = 0; i < covered.points.size() / 2; ++i) {
    covered.points[i] *= 0.05 / covered.points[i].norm();
  }
  const auto result = ParticleMatcher().match({room}, covered, {0.1, 0.2, 0.3});
  EXPECT_EQ(result.failure, MatchFailure::kTooManyNear);
  EXPECT_EQ(result.T_reference_scan.x, 0.1) << "the guess stands";
  EXPECT_EQ(result.confidence, 0.0);
  test::expectFinite(result);
  ParticleConfig config;
  config.max_near_share = 0.6;
  EXPECT_NE(ParticleMatcher(config).match({room}, covered, {}).failure, MatchFailure::kTooManyNear);
}

TEST(ParticleMatcherHostile, SenselessConfigurationThrows) {
  ParticleConfig config;
  config.particles = 1;
  config.rounds = -1;
  config.translation_deviation = 0.0;
  config.rotation_deviation = NAN;
  config.shrink = 1.1;
  config.space = "polar";
  config.near_range = -1.0;
  config.max_near_share = 1.1;
  config.error_cap = 0.0;
  EXPECT_EQ(config.validate().size(), 9U);
  EXPECT_THROW(ParticleMatcher{config}, std::invalid_argument);
  MatchConfig common;
  common.min_returns = 0;
  EXPECT_THROW(ParticleMatcher({}, common), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::matching

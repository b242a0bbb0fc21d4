// What both matchers that compare scans ray by ray make of senseless input.

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "omega_slam/matching/hill_climbing_matcher.h"
#include "omega_slam/matching/particle_matcher.h"
#include "support/match_results.h"
#include "support/room.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

using RayMatchers = ::testing::Types<HillClimbingMatcher, ParticleMatcher>;

template <typename Matcher>
using ConfigOf = std::conditional_t<std::is_same_v<Matcher, ParticleMatcher>, ParticleConfig,
                                    HillClimbingConfig>;

template <typename Matcher>
class RayMatcherHostile : public ::testing::Test {};
TYPED_TEST_SUITE(RayMatcherHostile, RayMatchers);

View roomSeenFrom(const Pose2& pose) {
  std::mt19937_64 random(1);
  return {test::measurePoints(test::furnishedRoom(), pose, 180, 0.01, random)};
}

TYPED_TEST(RayMatcherHostile, TooFewReturnsAreRefused) {
  const TypeParam matcher;
  const View room = roomSeenFrom({});
  for (const Points& points : {Points{}, Points{{1.0, 0.0}}, Points(29, {1.0, 1.0})}) {
    const View few{points};
    const auto result = matcher.match({room}, few, {0.1, 0.2, 0.3});
    EXPECT_EQ(result.failure, MatchFailure::kTooFewReturns);
    EXPECT_EQ(result.T_reference_scan.x, 0.1) << "the guess stands";
    test::expectFinite(result);
    EXPECT_EQ(matcher.match({few}, room, {}).failure, MatchFailure::kTooFewReturns);
  }
  EXPECT_EQ(matcher.match({}, room, {}).failure, MatchFailure::kTooFewReturns);
}

TYPED_TEST(RayMatcherHostile, OnlyTheNewestViewIsEmpty) {
  const View room = roomSeenFrom({});
  const auto result = TypeParam().match({room, View{}}, room, {0.05, 0.0, 0.0});
  EXPECT_LT(result.T_reference_scan.translation().norm(), 0.01);
}

TYPED_TEST(RayMatcherHostile, WhatIsNotFiniteIsRefused) {
  const View room = roomSeenFrom({});
  View odd = room;
  odd.points[7].y() = NAN;
  const TypeParam matcher;
  for (const auto& result :
       {matcher.match({room}, room, {NAN, 0.0, 0.0}), matcher.match({room}, odd, {}),
        matcher.match({odd}, room, {}), matcher.match({{room.points, {NAN, 0.0}}}, room, {})}) {
    EXPECT_EQ(result.failure, MatchFailure::kTooFewReturns);
    test::expectFinite(result);
  }
}

TYPED_TEST(RayMatcherHostile, ScansThatDoNotOverlap) {
  const View room = roomSeenFrom({});
  const auto result = TypeParam().match({room}, room, {50.0, 0.0, 0.0});
  EXPECT_EQ(result.failure, MatchFailure::kNoOverlap);
  EXPECT_EQ(result.confidence, 0.0);
  test::expectFinite(result);
}

TYPED_TEST(RayMatcherHostile, AllPointsInOnePlaceOrAtTheOrigin) {
  const TypeParam matcher;
  for (const Eigen::Vector2d& place : {Eigen::Vector2d(1.0, 1.0), Eigen::Vector2d(0.0, 0.0)}) {
    const View heap{Points(100, place)};
    test::expectFinite(matcher.match({heap}, heap, {}));
    test::expectFinite(matcher.match({heap}, heap, {0.3, 0.0, 0.1}));
    test::expectFinite(matcher.match({roomSeenFrom({})}, heap, {}));
    test::expectFinite(matcher.match({heap}, roomSeenFrom({}), {}));
  }
}

TYPED_TEST(RayMatcherHostile, HugeCoordinates) {
  const TypeParam matcher;
  const View room = roomSeenFrom({});
  const Pose2 far{1e6, -1e6, 0.5};
  const auto result = matcher.match({transformed(far, room)}, room, far * Pose2{0.05, 0.05, 0.05});
  EXPECT_LT(distance(result.T_reference_scan, far), 0.01);
  test::expectFinite(result);
  test::expectFinite(matcher.match({room}, room, {1e300, -1e300, 1e300}));
  test::expectFinite(matcher.match({room}, room, {1.7e308, -1.7e308, 0.0}));
}

TYPED_TEST(RayMatcherHostile, PointsBeyondAllMeasure) {
  const TypeParam matcher;
  const View room = roomSeenFrom({});
  for (const double scale : {1e6, 1e160, 1e300}) {
    View vast = room;
    for (Eigen::Vector2d& point : vast.points) {
      point *= scale;
    }
    View partly = room;
    partly.points[7] = vast.points[7];
    for (const View& odd : {vast, partly, View{room.points, {scale, -scale}}}) {
      test::expectFinite(matcher.match({room}, odd, {}));
      test::expectFinite(matcher.match({odd}, room, {}));
      test::expectFinite(matcher.match({odd}, odd, {scale, 0.0, 0.1}));
    }
  }
}

TYPED_TEST(RayMatcherHostile, ThreePointsAreNoPlace) {
  MatchConfig common;
  common.min_returns = 3;
  const TypeParam matcher({}, common);
  const View few{{{1.0, 2.0}, {-2.0, 1.0}, {1.0, -1.5}}};
  for (const auto& result :
       {matcher.match({few}, few, {}), matcher.match({roomSeenFrom({})}, few, {}),
        matcher.match({few}, roomSeenFrom({}), {})}) {
    EXPECT_NE(result.failure, MatchFailure::kNone);
    test::expectFinite(result);
  }
}

TYPED_TEST(RayMatcherHostile, IdenticalScansStayWhereTheyAre) {
  const View room = roomSeenFrom({});
  const auto result = TypeParam().match({room}, room, {});
  EXPECT_LT(distance(result.T_reference_scan, {}), 0.001);
  EXPECT_TRUE(result.converged);
  EXPECT_GT(result.confidence, 0.99);
}

TYPED_TEST(RayMatcherHostile, WithoutRoundsTheGuessIsJudged) {
  ConfigOf<TypeParam> config;
  config.rounds = 0;
  const View room = roomSeenFrom({});
  const Pose2 guess{0.01, 0.0, 0.0};
  const auto result = TypeParam(config).match({room}, room, guess);
  EXPECT_LT(distance(result.T_reference_scan, guess), 1e-12);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.failure, MatchFailure::kNotConverged);
  EXPECT_GT(result.confidence, 0.5);
  test::expectFinite(result);
}

}  // namespace
}  // namespace omega_slam::matching

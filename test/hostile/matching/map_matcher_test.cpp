#include "omega_slam/matching/map_matcher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/room.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr double kInf = std::numeric_limits<double>::infinity();
const double kNan = std::nan("");

void expectSane(const MatchResult& result) {
  EXPECT_TRUE(result.T_reference_scan.isFinite());
  EXPECT_TRUE(result.covariance.allFinite());
  EXPECT_TRUE(std::isfinite(result.residual));
  EXPECT_GE(result.confidence, 0.0);
  EXPECT_LE(result.confidence, 1.0);
  EXPECT_GE(result.overlap, 0.0);
  EXPECT_LE(result.overlap, 1.0);
}

View roomSeenFrom(const Pose2& pose) {
  std::mt19937_64 random(1);
  return {test::measurePoints(test::furnishedRoom(), pose, 180, 0.01, random), {0.0, 0.0}};
}

TEST(MapMatcherHostile, TooFewReturnsAreRefused) {
  const MapMatcher matcher;
  const View room = roomSeenFrom({});
  for (const Points& few : {Points{}, Points{{1.0, 0.0}}, Points(29, {1.0, 1.0})}) {
    const auto as_scan = matcher.match({room}, {few}, {0.1, 0.2, 0.3});
    EXPECT_EQ(as_scan.failure, MatchFailure::kTooFewReturns);
    EXPECT_EQ(as_scan.T_reference_scan.x, 0.1) << "the guess stands";
    EXPECT_EQ(as_scan.confidence, 0.0);
    expectSane(as_scan);
    EXPECT_EQ(matcher.match({{few}}, room, {}).failure, MatchFailure::kTooFewReturns);
  }
  EXPECT_EQ(matcher.match({}, room, {}).failure, MatchFailure::kTooFewReturns);
}

TEST(MapMatcherHostile, WithoutOverlapTheGuessStands) {
  const View room = roomSeenFrom({});
  for (const Pose2& guess : {Pose2{50.0, 0.0, 0.0}, {1e7, -1e7, 1.0}, {1e300, 0.0, 0.0}}) {
    const auto result = MapMatcher().match({room}, room, guess);
    EXPECT_EQ(result.failure, MatchFailure::kNoOverlap);
    EXPECT_EQ(result.confidence, 0.0);
    EXPECT_EQ(result.T_reference_scan.x, guess.x);
    expectSane(result);
  }
}

TEST(MapMatcherHostile, TrackingOnAnEmptyMapHasNoOverlap) {
  const auto result = MapMatcher().track(LocalMap(), roomSeenFrom({}), {0.1, 0.0, 0.0});
  EXPECT_EQ(result.failure, MatchFailure::kNoOverlap);
  expectSane(result);
}

TEST(MapMatcherHostile, AllPointsInOnePlace) {
  const View heap{Points(100, {1.0, 1.0}), {0.0, 0.0}};
  const View touched{Points(100, {1.0, 1.0}), {1.0, 1.0}};
  for (const View& reference : {heap, touched, roomSeenFrom({})}) {
    for (const View& scan : {heap, touched}) {
      const auto result = MapMatcher().match({reference}, scan, {0.02, 0.01, 0.1});
      EXPECT_NE(result.failure, MatchFailure::kNone) << "one place says nothing of the heading";
      expectSane(result);
    }
  }
}

TEST(MapMatcherHostile, PointsAtTheOrigin) {
  View room = roomSeenFrom({});
  room.points.insert(room.points.end(), 200, Eigen::Vector2d::Zero());
  expectSane(MapMatcher().match({room}, room, {0.05, 0.0, 0.0}));
}

TEST(MapMatcherHostile, LaserInsideOfAWall) {
  View room = roomSeenFrom({});
  room.origin = room.points.front();
  const auto result = MapMatcher().match({room}, room, {0.03, 0.02, 0.02});
  EXPECT_LT(result.T_reference_scan.translation().norm(), 0.01);
  expectSane(result);
}

TEST(MapMatcherHostile, WhatIsNotFiniteIsRefused) {
  const MapMatcher matcher;
  const View room = roomSeenFrom({});
  for (const double bad : {kNan, kInf, -kInf}) {
    for (const Pose2& guess : {Pose2{bad, 0.0, 0.0}, {0.0, bad, 0.0}, {0.0, 0.0, bad}}) {
      const auto result = matcher.match({room}, room, guess);
      EXPECT_EQ(result.failure, MatchFailure::kTooFewReturns);
      expectSane(result);
    }
    View broken = room;
    broken.points[7].y() = bad;
    EXPECT_EQ(matcher.match({room}, broken, {}).failure, MatchFailure::kTooFewReturns);
    EXPECT_EQ(matcher.match({broken}, room, {}).failure, MatchFailure::kTooFewReturns);
    LocalMap map;
    ASSERT_TRUE(map.insert(broken, {}));
    EXPECT_EQ(matcher.track(map, broken, {}).failure, MatchFailure::kTooFewReturns);
    EXPECT_EQ(matcher.track(map, room, {0.05, 0.0, 0.0}).failure, MatchFailure::kNone);
  }
}

TEST(MapMatcherHostile, HugeCoordinates) {
  View far = roomSeenFrom({});
  for (Eigen::Vector2d& point : far.points) {
    point *= 1e12;
  }
  expectSane(MapMatcher().match({far}, far, {}));
  expectSane(MapMatcher().match({roomSeenFrom({})}, far, {}));
  expectSane(MapMatcher().match({far}, roomSeenFrom({}), {}));
  const Pose2 T_far_room{9e5, -9e5, 2.0};
  const View room = roomSeenFrom({});
  const auto result = MapMatcher().match({transformed(T_far_room, room)}, room, T_far_room);
  EXPECT_GT(result.confidence, 0.9);
  expectSane(result);
}

TEST(MapMatcherHostile, NoIterationsJudgeTheGuess) {
  MapMatcherConfig config;
  config.max_iterations = 0;
  const View room = roomSeenFrom({});
  const auto result = MapMatcher(config).match({room}, room, {0.02, 0.0, 0.0});
  EXPECT_EQ(result.T_reference_scan.x, 0.02);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.failure, MatchFailure::kNotConverged);
  EXPECT_GT(result.overlap, 0.9);
  expectSane(result);
}

/// Finds nothing, and says so in the worst way.
class Useless : public ScanMatcher {
 public:
  explicit Useless(const Pose2& answer) : answer_(answer) {}
  MatchResult match(const Reference& /*reference*/, const View& /*scan*/,
                    const Pose2& /*guess*/) const override {
    MatchResult result;
    result.T_reference_scan = answer_;
    result.confidence = 1.0;
    return result;
  }

 private:
  Pose2 answer_;
};

TEST(MapMatcherHostile, FallbackIsNotBelievedBlindly) {
  const View room = roomSeenFrom({});
  for (const Pose2& answer : {Pose2{30.0, 0.0, 0.0}, {1e300, 1e300, 1.0}}) {
    const MapMatcher matcher({}, {}, std::make_unique<Useless>(answer));
    const auto result = matcher.match({room}, room, {1.5, 1.0, 1.0});
    EXPECT_LT(result.T_reference_scan.translation().norm(), 5.0);
    EXPECT_LT(result.confidence, 0.6);
    expectSane(result);
  }
}

TEST(MapMatcherHostile, SenselessConfigurationThrows) {
  MapMatcherConfig config;
  config.max_iterations = -1;
  config.min_confidence = kNan;
  config.map.levels = 0;
  EXPECT_EQ(config.validate().size(), 3U);
  EXPECT_THROW(MapMatcher{config}, std::invalid_argument);
  MatchConfig common;
  common.range_noise = 0.0;
  EXPECT_THROW(MapMatcher({}, common), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::matching

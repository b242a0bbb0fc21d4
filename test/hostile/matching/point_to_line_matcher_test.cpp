#include "omega_slam/matching/point_to_line_matcher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/room.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

void expectSane(const MatchResult& result) {
  EXPECT_TRUE(result.T_reference_scan.isFinite());
  EXPECT_TRUE(result.covariance.allFinite());
  EXPECT_GE(result.confidence, 0.0);
  EXPECT_LE(result.confidence, 1.0);
  EXPECT_TRUE(std::isfinite(result.overlap));
  EXPECT_TRUE(std::isfinite(result.residual));
  EXPECT_TRUE(!result.open_direction || result.open_direction->allFinite());
}

View roomSeenFrom(const Pose2& pose) {
  std::mt19937_64 random(1);
  return {test::measurePoints(test::furnishedRoom(), pose, 180, 0.01, random)};
}

MatchResult match(const View& reference, const View& scan, const Pose2& guess = {}) {
  const MatchResult result = PointToLineMatcher().match({reference}, scan, guess);
  expectSane(result);
  return result;
}

TEST(PointToLineMatcherHostile, TooFewReturnsAreRefused) {
  const View room = roomSeenFrom({});
  for (const Points& few : {Points{}, Points{{1.0, 0.0}}, Points(29, {1.0, 1.0})}) {
    const auto as_scan = match(room, {few}, {0.1, 0.2, 0.3});
    EXPECT_EQ(as_scan.failure, MatchFailure::kTooFewReturns);
    EXPECT_EQ(as_scan.T_reference_scan.x, 0.1) << "the guess stands";
    EXPECT_EQ(as_scan.confidence, 0.0);
    EXPECT_EQ(match({few}, room).failure, MatchFailure::kTooFewReturns);
  }
  const auto nothing = PointToLineMatcher().match({}, room, {});
  EXPECT_EQ(nothing.failure, MatchFailure::kTooFewReturns);
}

TEST(PointToLineMatcherHostile, ScansThatDoNotOverlap) {
  const View room = roomSeenFrom({});
  for (const Pose2& far : {Pose2{50.0, 0.0, 0.0}, Pose2{-1e6, 1e7, 1.0}}) {
    const auto result = match(room, room, far);
    EXPECT_EQ(result.failure, MatchFailure::kNoOverlap);
    EXPECT_EQ(result.confidence, 0.0);
    EXPECT_NEAR(result.T_reference_scan.x, far.x, 1e-9) << "the guess stands";
  }
}

TEST(PointToLineMatcherHostile, AllPointsInOnePlace) {
  const View heap{Points(100, {1.0, 1.0})};
  const View room = roomSeenFrom({});
  EXPECT_EQ(match(heap, heap).failure, MatchFailure::kDegenerate);
  EXPECT_NE(match(room, heap).failure, MatchFailure::kNone);
  EXPECT_NE(match(heap, room).failure, MatchFailure::kNone);
}

TEST(PointToLineMatcherHostile, AllPointsOnOneLine) {
  View line;
  for (int i = 0; i < 100; ++i) {
    line.points.emplace_back(0.03 * i, 1.0);
  }
  const auto result = match(line, line, {0.05, 0.05, 0.02});
  EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
  ASSERT_TRUE(result.open_direction);
  EXPECT_GT(std::abs(result.open_direction->x()), 0.99);
  EXPECT_NEAR(result.T_reference_scan.y, 0.0, 1e-3);
}

TEST(PointToLineMatcherHostile, EachPointManyTimes) {
  View reference = roomSeenFrom({});
  const Points once = reference.points;
  for (int i = 0; i < 5; ++i) {
    reference.points.insert(reference.points.end(), once.begin(), once.end());
  }
  const auto result = match(reference, reference, {0.05, -0.05, 0.03});
  EXPECT_NEAR(result.T_reference_scan.x, 0.0, 1e-3);
  EXPECT_NEAR(result.T_reference_scan.y, 0.0, 1e-3);
  EXPECT_NEAR(result.T_reference_scan.theta, 0.0, 1e-3);
}

TEST(PointToLineMatcherHostile, GuessThatIsNotFinite) {
  const View room = roomSeenFrom({});
  for (const double bad : {kNan, kInf, -kInf}) {
    EXPECT_NE(match(room, room, {bad, 0.0, 0.0}).failure, MatchFailure::kNone);
    EXPECT_NE(match(room, room, {0.0, bad, 0.0}).failure, MatchFailure::kNone);
    EXPECT_NE(match(room, room, {0.0, 0.0, bad}).failure, MatchFailure::kNone);
  }
}

TEST(PointToLineMatcherHostile, PointThatIsNotFinite) {
  const View room = roomSeenFrom({});
  for (const double bad : {kNan, kInf, -kInf}) {
    View broken = room;
    broken.points[20].y() = bad;
    EXPECT_NE(match(broken, room).failure, MatchFailure::kNone);
    EXPECT_NE(match(room, broken).failure, MatchFailure::kNone);
    broken = room;
    broken.origin.x() = bad;
    EXPECT_NE(match(broken, room).failure, MatchFailure::kNone);
  }
}

TEST(PointToLineMatcherHostile, HugeCoordinates) {
  const View room = roomSeenFrom({});
  for (const double far : {1e5, 1e8, 1e12, 1e18, 1e155, 1e300}) {
    const View moved = transformed({far, -far, 0.5}, room);
    match(moved, room, {far, -far, 0.5});
    match(moved, moved);
    View scattered = room;
    scattered.points[7] = {far, far};
    match(scattered, room, {0.05, 0.05, 0.03});
    match(room, scattered, {0.05, 0.05, 0.03});
    match(scattered, scattered);
  }
  const View near = transformed({1e5, -1e5, 0.5}, room);
  const auto result = match(near, room, {1e5 + 0.05, -1e5 - 0.05, 0.52});
  EXPECT_NEAR(result.T_reference_scan.x, 1e5, 1e-3);
  EXPECT_NEAR(result.T_reference_scan.y, -1e5, 1e-3);
}

TEST(PointToLineMatcherHostile, WithoutIterationsTheGuessIsJudged) {
  PointToLineMatcherConfig config;
  config.max_iterations = 0;
  const View room = roomSeenFrom({});
  const Pose2 guess{0.01, 0.02, 0.01};
  const auto result = PointToLineMatcher(config).match({room}, room, guess);
  expectSane(result);
  EXPECT_EQ(result.failure, MatchFailure::kNotConverged);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.T_reference_scan.vector(), guess.vector());
  EXPECT_GT(result.confidence, 0.5);
}

TEST(PointToLineMatcherHostile, FewIterationsSayThatTheyWereTooFew) {
  const View room = roomSeenFrom({});
  for (int iterations = 1; iterations < 6; ++iterations) {
    PointToLineMatcherConfig config;
    config.max_iterations = iterations;
    const auto result = PointToLineMatcher(config).match({room}, room, {0.1, 0.1, 0.1});
    expectSane(result);
    EXPECT_FALSE(result.converged);
  }
}

TEST(PointToLineMatcherHostile, ReachBelowTheOutlierDistance) {
  PointToLineMatcherConfig config;
  config.max_correspondence_distance = 1e-3;
  const View room = roomSeenFrom({});
  expectSane(PointToLineMatcher(config).match({room}, room, {0.1, 0.1, 0.1}));
  config.max_correspondence_distance = 1e6;
  expectSane(PointToLineMatcher(config).match({room}, room, {0.1, 0.1, 0.1}));
}

TEST(PointToLineMatcherHostile, SenselessConfigurationThrows) {
  PointToLineMatcherConfig config;
  config.max_iterations = -1;
  config.max_correspondence_distance = kNan;
  EXPECT_EQ(config.validate().size(), 2U);
  EXPECT_THROW(PointToLineMatcher{config}, std::invalid_argument);
  MatchConfig common;
  common.outlier_distance = 0.0;
  EXPECT_THROW(PointToLineMatcher({}, common), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::matching

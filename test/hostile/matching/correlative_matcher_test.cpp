#include "omega_slam/matching/correlative_matcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "support/match_results.h"
#include "support/poses.h"
#include "support/room.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

View roomSeenFrom(const Pose2& pose) {
  std::mt19937_64 random(1);
  return {test::measurePoints(test::furnishedRoom(), pose, 180, 0.01, random), {0.0, 0.0}};
}

TEST(CorrelativeMatcherHostile, TooFewReturnsAreRefused) {
  const CorrelativeMatcher matcher;
  const View room = roomSeenFrom({});
  for (const Points& few : {Points{}, Points{{1.0, 0.0}}, Points(29, {1.0, 1.0})}) {
    const auto as_scan = matcher.match({room}, {few}, {0.1, 0.2, 0.3});
    EXPECT_EQ(as_scan.failure, MatchFailure::kTooFewReturns);
    EXPECT_EQ(as_scan.T_reference_scan.x, 0.1) << "the guess stands";
    test::expectFinite(as_scan);
    EXPECT_EQ(matcher.match({{few}}, room, {}).failure, MatchFailure::kTooFewReturns);
  }
  EXPECT_EQ(matcher.match({}, room, {}).failure, MatchFailure::kTooFewReturns);
}

TEST(CorrelativeMatcherHostile, NumbersThatAreNone) {
  const CorrelativeMatcher matcher;
  const View room = roomSeenFrom({});
  for (const double none : {std::nan(""), kInfinity, -kInfinity}) {
    View broken = room;
    broken.points[17].y() = none;
    test::expectFinite(matcher.match({room}, broken, {}));
    test::expectFinite(matcher.match({broken}, room, {}));
    test::expectFinite(matcher.match({room}, room, {none, 0.0, 0.0}));
    test::expectFinite(matcher.match({room}, room, {0.0, 0.0, none}));
    broken = room;
    broken.origin.x() = none;
    test::expectFinite(matcher.match({room}, broken, {}));
  }
}

TEST(CorrelativeMatcherHostile, ScansThatDoNotOverlapAreRefused) {
  const View room = roomSeenFrom({});
  const auto result = CorrelativeMatcher().match({room}, room, {50.0, 1.0, 0.5});
  EXPECT_EQ(result.failure, MatchFailure::kNoOverlap);
  EXPECT_EQ(result.confidence, 0.0);
  EXPECT_EQ(result.T_reference_scan.vector(), Eigen::Vector3d(50.0, 1.0, 0.5));
}

TEST(CorrelativeMatcherHostile, AllPointsInOnePlace) {
  const CorrelativeMatcher matcher;
  const View heap{Points(100, {1.0, 1.0}), {0.0, 0.0}};
  const auto result = matcher.match({heap}, heap, {});
  test::expectFinite(result);
  EXPECT_EQ(result.failure, MatchFailure::kDegenerate) << "a point leaves all directions open";
  test::expectFinite(matcher.match({roomSeenFrom({})}, heap, {}));
  test::expectFinite(matcher.match({heap}, roomSeenFrom({}), {}));
  const View at_the_laser{Points(100, {0.0, 0.0}), {0.0, 0.0}};
  test::expectFinite(matcher.match({at_the_laser}, at_the_laser, {}));
}

TEST(CorrelativeMatcherHostile, PointsInNoOrder) {
  std::mt19937_64 random(5);
  View shuffled = roomSeenFrom({});
  std::shuffle(shuffled.points.begin(), shuffled.points.end(), random);
  test::expectFinite(CorrelativeMatcher().match({shuffled}, shuffled, {0.05, 0.05, 0.05}));
}

TEST(CorrelativeMatcherHostile, PointsAMillionMetresApartNeedNoMoreMemory) {
  const CorrelativeMatcher matcher;
  View room = roomSeenFrom({});
  for (const double far : {1e3, 1e6, 1e15, 1e300}) {
    View spread = room;
    spread.points.insert(spread.points.begin() + 30, {far, -far});
    spread.points.insert(spread.points.begin() + 60, {-far, far});
    for (const auto& result : {matcher.match({spread}, room, {0.1, 0.1, 0.1}),
                               matcher.match({room}, spread, {0.1, 0.1, 0.1}),
                               matcher.match({spread}, spread, {0.1, 0.1, 0.1})}) {
      test::expectFinite(result);
      EXPECT_LT(test::gapBetween(result.T_reference_scan, {}).translation, 0.01) << far;
    }
    test::expectFinite(matcher.match({room}, room, {far, -far, far}));
    View seen_from_afar = room;
    seen_from_afar.origin = {far, -far};
    test::expectFinite(matcher.match({seen_from_afar}, seen_from_afar, {0.1, 0.1, 0.1}));
  }
}

TEST(CorrelativeMatcherHostile, NothingButFarReturns) {
  View far;
  for (int i = 0; i < 60; ++i) {
    far.points.emplace_back(5000.0 + i, 10.0 * i);
  }
  const auto result = CorrelativeMatcher().match({far}, far, {});
  test::expectFinite(result);
  EXPECT_EQ(result.failure, MatchFailure::kNoOverlap);
}

TEST(CorrelativeMatcherHostile, BeamsTooFarApartToJoin) {
  std::mt19937_64 random(1);
  const View sparse{test::measurePoints(test::furnishedRoom(), {}, 36, 0.0, random), {0.0, 0.0}};
  const auto result = CorrelativeMatcher().match({sparse}, sparse, {0.1, 0.1, 0.05});
  test::expectFinite(result);
  EXPECT_LT(test::gapBetween(result.T_reference_scan, {}).translation, 0.05);
}

TEST(CorrelativeMatcherHostile, WithoutRefinementTheSearchAnswers) {
  CorrelativeMatcherConfig config;
  config.max_refinements = 0;
  const Pose2 truth{0.2, -0.1, 0.2};
  const auto result = CorrelativeMatcher(config).match({roomSeenFrom({})}, roomSeenFrom(truth), {});
  test::expectFinite(result);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.failure, MatchFailure::kNotConverged);
  EXPECT_LT(test::gapBetween(result.T_reference_scan, truth).translation, 0.04);
}

TEST(CorrelativeMatcherHostile, WindowWithoutAnExtentHoldsTheGuess) {
  CorrelativeMatcherConfig config;
  config.window = {0.0, 0.0};
  const View room = roomSeenFrom({});
  const auto result = CorrelativeMatcher(config).match({room}, room, {0.03, -0.02, 0.01});
  test::expectFinite(result);
  EXPECT_LT(test::gapBetween(result.T_reference_scan, {}).translation, 2e-3);
}

TEST(CorrelativeMatcherHostile, SenselessConfigurationThrows) {
  CorrelativeMatcherConfig config;
  config.window = {-0.1, 4.0};
  config.resolution = 0.0;
  config.max_refinements = -1;
  EXPECT_EQ(config.validate().size(), 4U);
  EXPECT_THROW(CorrelativeMatcher{config}, std::invalid_argument);
  config = {};
  config.resolution = std::nan("");
  EXPECT_EQ(config.validate().size(), 1U);
  MatchConfig common;
  common.outlier_distance = -1.0;
  EXPECT_THROW(CorrelativeMatcher({}, common), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::matching

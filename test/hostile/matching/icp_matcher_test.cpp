#include "omega_slam/matching/icp_matcher.h"

#include <gtest/gtest.h>

#include "support/match_results.h"
#include "support/room.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

Points roomSeenFrom(const Pose2& pose) {
  std::mt19937_64 random(1);
  return test::measurePoints(test::furnishedRoom(), pose, 180, 0.01, random);
}

TEST(IcpMatcherHostile, TooFewReturnsAreRefused) {
  const IcpMatcher matcher;
  const Points room = roomSeenFrom({});
  for (const Points& few : {Points{}, Points{{1.0, 0.0}}, Points(29, {1.0, 1.0})}) {
    const auto as_scan = matcher.match({{room}}, {few}, {0.1, 0.2, 0.3});
    EXPECT_EQ(as_scan.failure, MatchFailure::kTooFewReturns);
    EXPECT_EQ(as_scan.T_reference_scan.x, 0.1) << "the guess stands";
    EXPECT_EQ(as_scan.confidence, 0.0);
    test::expectFinite(as_scan);
    EXPECT_EQ(matcher.match({{few}}, {room}, {}).failure, MatchFailure::kTooFewReturns);
  }
}

TEST(IcpMatcherHostile, ScansThatDoNotOverlapAreRefused) {
  const Points room = roomSeenFrom({});
  const auto result = IcpMatcher().match({{room}}, {room}, {50.0, 0.0, 0.0});
  EXPECT_EQ(result.failure, MatchFailure::kNoOverlap);
  EXPECT_EQ(result.confidence, 0.0);
  test::expectFinite(result);
}

TEST(IcpMatcherHostile, AllPointsInOnePlace) {
  const Points heap(100, {1.0, 1.0});
  test::expectFinite(IcpMatcher().match({{heap}}, {heap}, {}));
  test::expectFinite(IcpMatcher().match({{roomSeenFrom({})}}, {heap}, {}));
}

TEST(IcpMatcherHostile, GuessThatIsNotFinite) {
  const Points room = roomSeenFrom({});
  test::expectFinite(IcpMatcher().match({{room}}, {room}, {std::nan(""), 0.0, 0.0}));
}

TEST(IcpMatcherHostile, OneIterationStillAnswers) {
  IcpMatcherConfig config;
  config.max_iterations = 1;
  test::expectFinite(
      IcpMatcher(config).match({{roomSeenFrom({})}}, {roomSeenFrom({0.3, 0.2, 0.3})}, {}));
}

TEST(IcpMatcherHostile, SenselessConfigurationThrows) {
  IcpMatcherConfig config;
  config.max_iterations = 0;
  config.max_correspondence_distance = 0.0;
  EXPECT_EQ(config.validate().size(), 2U);
  EXPECT_THROW(IcpMatcher{config}, std::invalid_argument);
  MatchConfig common;
  common.min_returns = 2;
  common.outlier_distance = -1.0;
  common.range_noise = 0.0;
  EXPECT_EQ(common.validate().size(), 3U);
  EXPECT_THROW(IcpMatcher({}, common), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::matching

#include "omega_slam/matching/icp_matcher.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

TEST(IcpMatcherLaws, RecoversDisplacementsOfAScan) {
  const IcpMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
      const Points reference = test::measurePoints(
          test::furnishedRoom(), test::randomPose(0.8, 3.1, random), 360, 0.0, random);
      const Pose2 truth = test::randomPose(0.15, 0.12, random);
      Points scan;
      for (const auto& p : reference) {
        scan.push_back(truth.inverse() * p);
      }
      const MatchResult result = matcher.match({{reference}}, {scan}, {});
      const auto gap = test::gapBetween(result.T_reference_scan, truth);
      EXPECT_LT(gap.translation, 0.01) << i;
      // Point-to-point ICP may lock one beam off: a beam is 0.0175 rad.
      EXPECT_LT(gap.rotation, 0.018) << i;
      EXPECT_GT(result.confidence, 0.9) << i;
    }
  }
}

TEST(IcpMatcherLaws, MatchesNoisyScansFromTwoPlaces) {
  const IcpMatcher matcher;
  int good = 0;
  int all = 0;
  for (const auto seed : test::seeds()) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.2, 0.3, random);
      const auto room = test::furnishedRoom();
      const Points reference = test::measurePoints(room, first, 360, 0.01, random);
      const Points scan = test::measurePoints(room, first * truth, 360, 0.01, random);
      const Pose2 guess = truth * test::randomPose(0.08, 0.06, random);
      const auto result = matcher.match({{reference}}, {scan}, guess);
      const auto gap = test::gapBetween(result.T_reference_scan, truth);
      ++all;
      good += gap.translation < 0.04 && gap.rotation < 0.02 ? 1 : 0;
    }
  }
  EXPECT_GE(good, 95 * all / 100) << good << " of " << all;
}

TEST(IcpMatcherLaws, FrameOfTheReferenceDoesNotMatter) {
  const IcpMatcher matcher;
  std::mt19937_64 random(3);
  const Points reference = test::measurePoints(test::furnishedRoom(), {}, 360, 0.0, random);
  const Points scan =
      test::measurePoints(test::furnishedRoom(), {0.1, 0.05, 0.05}, 360, 0.0, random);
  const Pose2 T_other_reference{5.0, -2.0, 1.0};
  Points moved;
  for (const auto& p : reference) {
    moved.push_back(T_other_reference * p);
  }
  const auto here = matcher.match({{reference}}, {scan}, {});
  const auto there = matcher.match({{moved}}, {scan}, T_other_reference);
  const auto gap =
      test::gapBetween(T_other_reference * here.T_reference_scan, there.T_reference_scan);
  EXPECT_LT(gap.translation, 2e-3);
  EXPECT_LT(gap.rotation, 1e-3);
}

}  // namespace
}  // namespace omega_slam::matching

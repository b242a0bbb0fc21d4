// Laws of both matchers that compare scans ray by ray.

#include <gtest/gtest.h>

#include <type_traits>

#include "omega_slam/matching/hill_climbing_matcher.h"
#include "omega_slam/matching/particle_matcher.h"
#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

template <typename Matcher>
class RayMatcherLaws : public ::testing::Test {
 protected:
  /// Share of matches of noisy scans that come out right, at least.
  static constexpr double kLeastShare = std::is_same_v<Matcher, ParticleMatcher> ? 0.9 : 0.85;
};
using RayMatchers = ::testing::Types<HillClimbingMatcher, ParticleMatcher>;
TYPED_TEST_SUITE(RayMatcherLaws, RayMatchers);

View seenFrom(const Pose2& T_room_laser, double noise, std::mt19937_64& random) {
  return {test::measurePoints(test::furnishedRoom(), T_room_laser, 360, noise, random)};
}

TYPED_TEST(RayMatcherLaws, RecoversDisplacementsOfAScan) {
  const TypeParam matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 10; ++i) {
      const View reference = seenFrom(test::randomPose(0.8, 3.1, random), 0.0, random);
      const Pose2 truth = test::randomPose(0.2, 0.15, random);
      const View scan = transformed(truth.inverse(), reference);
      const MatchResult result = matcher.match({reference}, scan, {});
      const auto gap = test::gapBetween(result.T_reference_scan, truth);
      EXPECT_LT(gap.translation, 0.01) << i;
      EXPECT_LT(gap.rotation, 0.005) << i;
      EXPECT_GT(result.confidence, 0.9) << i;
    }
  }
}

TYPED_TEST(RayMatcherLaws, MatchesNoisyScansFromTwoPlaces) {
  const TypeParam matcher;
  int good = 0;
  int all = 0;
  for (const auto seed : test::seeds()) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < 10; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.3, 0.3, random);
      const View reference = seenFrom(first, 0.01, random);
      const View scan = seenFrom(first * truth, 0.01, random);
      const Pose2 guess = truth * test::randomPose(0.1, 0.09, random);
      const auto result = matcher.match({reference}, scan, guess);
      const auto gap = test::gapBetween(result.T_reference_scan, truth);
      ++all;
      good += gap.translation < 0.05 && gap.rotation < 0.0175 ? 1 : 0;
    }
  }
  EXPECT_GE(good, TestFixture::kLeastShare * all) << good << " of " << all;
}

/// A scan and a guess that is a little off.
struct Case {
  View reference;
  View scan;
  Pose2 guess;
};

Case drawCase(std::mt19937_64& random) {
  Case drawn;
  const Pose2 first = test::randomPose(0.8, 3.1, random);
  const Pose2 truth = test::randomPose(0.3, 0.3, random);
  drawn.reference = seenFrom(first, 0.0, random);
  drawn.scan = seenFrom(first * truth, 0.0, random);
  drawn.guess = truth * test::randomPose(0.1, 0.1, random);
  return drawn;
}

void expectSame(const Pose2& a, const Pose2& b) {
  const auto gap = test::gapBetween(a, b);
  EXPECT_LT(gap.translation, 0.03);
  EXPECT_LT(gap.rotation, 0.01);
}

TYPED_TEST(RayMatcherLaws, FrameOfTheReferenceDoesNotMatter) {
  const TypeParam matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 3; ++i) {
      const Case drawn = drawCase(random);
      const Pose2 T_other_reference = test::randomPose(10.0, 3.1, random);
      const auto here = matcher.match({drawn.reference}, drawn.scan, drawn.guess);
      const auto there = matcher.match({transformed(T_other_reference, drawn.reference)},
                                       drawn.scan, T_other_reference * drawn.guess);
      expectSame(T_other_reference * here.T_reference_scan, there.T_reference_scan);
    }
  }
}

TYPED_TEST(RayMatcherLaws, MountOfTheLaserDoesNotMatter) {
  const TypeParam matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 3; ++i) {
      const Case drawn = drawCase(random);
      const Pose2 T_base_laser = test::randomPose(0.5, 3.1, random);
      const auto of_laser = matcher.match({drawn.reference}, drawn.scan, drawn.guess);
      const auto of_base = matcher.match({drawn.reference}, transformed(T_base_laser, drawn.scan),
                                         drawn.guess * T_base_laser.inverse());
      expectSame(of_laser.T_reference_scan, of_base.T_reference_scan * T_base_laser);
    }
  }
}

}  // namespace
}  // namespace omega_slam::matching

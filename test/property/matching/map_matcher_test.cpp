#include "omega_slam/matching/map_matcher.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/matching/correlative_matcher.h"
#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

View viewFrom(const test::Room& room, const Pose2& T_room_laser, double noise,
              std::mt19937_64& random) {
  return {test::measurePoints(room, T_room_laser, 360, noise, random), {0.0, 0.0}};
}

/// Squared length of the error of a match, measured by its own covariance.
double squaredMahalanobis(const MatchResult& result, const Pose2& truth) {
  const Pose2& found = result.T_reference_scan;
  const Eigen::Vector3d error(found.x - truth.x, found.y - truth.y,
                              geometry::angleDifference(found.theta, truth.theta));
  return error.dot(result.covariance.inverse() * error);
}

constexpr double kThreeSigma = 14.16;  // chi-squared of three degrees of freedom, 99.73 %

TEST(MapMatcherLaws, RecoversDisplacementsOfAScan) {
  const MapMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
      const View reference =
          viewFrom(test::furnishedRoom(), test::randomPose(0.8, 3.1, random), 0.0, random);
      const Pose2 truth = test::randomPose(0.15, 0.12, random);
      const View scan = transformed(truth.inverse(), reference);
      const MatchResult result = matcher.match({reference}, scan, {});
      const auto gap = test::gapBetween(result.T_reference_scan, truth);
      EXPECT_LT(gap.translation, 0.0125) << i;  // half a cell; 12.03 mm at most, of 100 seeds
      EXPECT_LT(gap.rotation, 0.003) << i;
      EXPECT_GT(result.confidence, 0.9) << i;
      EXPECT_TRUE(result.converged) << i;
    }
  }
}

TEST(MapMatcherLaws, MatchesNoisyScansFromTwoPlacesWithinItsCovariance) {
  const MapMatcher matcher;
  int good = 0;
  int trusted = 0;
  int inside = 0;
  int all = 0;
  for (const auto seed : test::seeds()) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < 40; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.2, 0.3, random);
      const auto room = test::furnishedRoom();
      const View reference = viewFrom(room, first, 0.02, random);
      const View scan = viewFrom(room, first * truth, 0.02, random);
      const Pose2 guess = truth * test::randomPose(0.08, 0.08, random);
      const MatchResult result = matcher.match({reference}, scan, guess);
      const auto gap = test::gapBetween(result.T_reference_scan, truth);
      ++all;
      good += gap.translation < 0.02 && gap.rotation < 0.01 ? 1 : 0;
      if (result.failure == MatchFailure::kNone) {
        ++trusted;
        inside += squaredMahalanobis(result, truth) <= kThreeSigma ? 1 : 0;
      }
    }
  }
  EXPECT_GE(good, 98 * all / 100) << good << " of " << all;
  EXPECT_GE(trusted, 98 * all / 100) << trusted << " of " << all;
  EXPECT_GE(inside, 97 * trusted / 100) << inside << " of " << trusted;
}

TEST(MapMatcherLaws, FrameOfTheReferenceMattersNoMoreThanTheGrid) {
  const MapMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const View reference = viewFrom(test::furnishedRoom(), {}, 0.01, random);
    const View scan = viewFrom(test::furnishedRoom(), {0.1, 0.05, 0.05}, 0.01, random);
    const Pose2 T_other_reference = test::randomPose(50.0, 3.0, random);
    const View moved = transformed(T_other_reference, reference);
    const auto here = matcher.match({reference}, scan, {});
    const auto there = matcher.match({moved}, scan, T_other_reference);
    const auto gap =
        test::gapBetween(T_other_reference * here.T_reference_scan, there.T_reference_scan);
    // The cells are turned, a third of one is 8 mm; of 100 seeds, one is off by more than 6 mm.
    EXPECT_LT(gap.translation, 8e-3);
    EXPECT_LT(gap.rotation, 4e-3);
  }
}

TEST(MapMatcherLaws, ThereAndBackIsNowhereWithinTheCovariances) {
  const MapMatcher matcher;
  int inside = 0;
  int all = 0;
  for (const auto seed : test::seeds()) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.2, 0.3, random);
      const View a = viewFrom(test::furnishedRoom(), first, 0.01, random);
      const View b = viewFrom(test::furnishedRoom(), first * truth, 0.01, random);
      const MatchResult there = matcher.match({a}, b, truth);
      const MatchResult back = matcher.match({b}, a, truth.inverse());
      const Pose2 gap = there.T_reference_scan * back.T_reference_scan;
      // Both err alike at most: the covariance of the sum is bounded by twice the two.
      const double bound = 2.0 * (there.covariance.trace() + back.covariance.trace());
      ++all;
      inside += gap.vector().squaredNorm() <= 9.0 * bound ? 1 : 0;
      EXPECT_LT(gap.translation().norm(), 0.02);
    }
  }
  EXPECT_EQ(inside, all);
}

TEST(MapMatcherLaws, TracksAsItMatches) {
  std::mt19937_64 random(4);
  const Pose2 T_map_room{0.013, 0.027, 0.3};  // no beam runs along the border of two cells
  const View reference = viewFrom(test::furnishedRoom(), {}, 0.01, random);
  const View scan = viewFrom(test::furnishedRoom(), {0.1, 0.05, 0.05}, 0.01, random);
  const MapMatcher matcher;
  LocalMap map;
  ASSERT_TRUE(map.insert(reference, T_map_room));
  const MatchResult matched = matcher.match({transformed(T_map_room, reference)}, scan, T_map_room);
  const MatchResult tracked = matcher.track(map, scan, T_map_room);
  // The windows begin elsewhere, so that places in them are rounded otherwise.
  const auto gap = test::gapBetween(tracked.T_reference_scan, matched.T_reference_scan);
  EXPECT_LT(gap.translation, 1e-9);
  EXPECT_LT(gap.rotation, 1e-9);
  EXPECT_LT((tracked.covariance - matched.covariance).norm(), 1e-9 * matched.covariance.norm());
}

TEST(MapMatcherLaws, CorridorIsOpenAlongItAndHeldThere) {
  const MapMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const View reference = viewFrom(test::endlessCorridor(), {}, 0.01, random);
    const View scan = viewFrom(test::endlessCorridor(), {0.3, 0.0, 0.0}, 0.01, random);
    const Pose2 guess{0.4, 0.05, 0.02};
    const MatchResult result = matcher.match({reference}, scan, guess);
    EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
    ASSERT_TRUE(result.open_direction);
    EXPECT_GT(std::abs(result.open_direction->x()), 0.99);
    EXPECT_GT(std::sqrt(result.covariance(0, 0)), 0.3);
    EXPECT_NEAR(result.T_reference_scan.x, 0.4, 0.01) << "the guess stands";
    EXPECT_NEAR(result.T_reference_scan.y, 0.0, 0.01);
    EXPECT_NEAR(result.T_reference_scan.theta, 0.0, 0.005);
  }
}

TEST(MapMatcherLaws, RoundRoomIsOpenInItsTurn) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 0.01);
  const auto ring = [&] {
    View view;
    for (int i = 0; i < 360; ++i) {
      const double angle = geometry::degreesToRadians(i);
      const double range = 2.0 + noise(random);
      view.points.emplace_back(range * std::cos(angle), range * std::sin(angle));
    }
    return view;
  };
  const MatchResult result = MapMatcher().match({ring()}, ring(), {0.03, 0.02, 0.2});
  EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
  ASSERT_TRUE(result.open_direction);
  EXPECT_GT(std::abs(result.open_direction->z()), 0.99);
  EXPECT_NEAR(result.T_reference_scan.theta, 0.2, 0.01) << "the guess stands";
  EXPECT_LT(result.T_reference_scan.translation().norm(), 0.02);
}

TEST(MapMatcherLaws, LostItIsFoundByTheFallback) {
  const MapMatcher alone;
  CorrelativeMatcherConfig wide;
  wide.window = {1.0, 0.6};
  const MapMatcher helped({}, {}, std::make_unique<CorrelativeMatcher>(wide));
  int lost = 0;
  int found = 0;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 5; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const View reference = viewFrom(test::furnishedRoom(), first, 0.01, random);
      const View scan = viewFrom(test::furnishedRoom(), first, 0.01, random);
      const Pose2 guess{0.8, -0.5, 0.5};
      const MatchResult without = alone.match({reference}, scan, guess);
      const MatchResult with = helped.match({reference}, scan, guess);
      if (without.T_reference_scan.translation().norm() < 0.1) {
        continue;
      }
      ++lost;
      EXPECT_LT(without.confidence, 0.6) << "lost, it should know so";
      EXPECT_LT(test::gapBetween(with.T_reference_scan, {}).translation, 0.02) << i;
      EXPECT_GT(with.confidence, 0.8) << i;
      ++found;
    }
  }
  EXPECT_GE(lost, 5) << "the guesses are too good for this test";
  EXPECT_EQ(found, lost);
}

}  // namespace
}  // namespace omega_slam::matching

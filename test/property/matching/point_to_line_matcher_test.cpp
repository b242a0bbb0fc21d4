#include "omega_slam/matching/point_to_line_matcher.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "omega_slam/geometry/covariance.h"
#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

View look(const test::Room& room, const Pose2& place, int beams, double noise,
          std::mt19937_64& random) {
  return {test::measurePoints(room, place, beams, noise, random)};
}

/// A guess off by up to 0.1 m along each axis and 5 degrees.
Pose2 spoil(const Pose2& truth, std::mt19937_64& random) {
  return Pose2::fromVector(truth.vector() + test::randomPose(0.1, 0.087, random).vector());
}

double squaredMahalanobis(const Pose2& error, const Eigen::Matrix3d& covariance) {
  return error.vector().dot(covariance.inverse() * error.vector());
}

TEST(PointToLineMatcherLaws, RecoversDisplacementsOfAScan) {
  const PointToLineMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
      const View reference =
          look(test::furnishedRoom(), test::randomPose(0.8, 3.1, random), 360, 0.0, random);
      const Pose2 truth = test::randomPose(0.5, 3.1, random);
      const MatchResult result =
          matcher.match({reference}, transformed(truth.inverse(), reference), spoil(truth, random));
      const auto gap = test::gapBetween(result.T_reference_scan, truth);
      EXPECT_LT(gap.translation, 1e-3) << i;
      EXPECT_LT(gap.rotation, 1e-3) << i;
      EXPECT_GT(result.confidence, 0.99) << i;
      EXPECT_TRUE(result.converged) << i;
    }
  }
}

/// What is given up is refused; the rest ends as it would have without.
TEST(PointToLineMatcherLaws, GivesUpEarlyWhatTheCallerHasNoUseFor) {
  constexpr double kLeast = 0.7;
  const PointToLineMatcher patient;
  const PointToLineMatcher hasty({}, {}, kLeast);
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    int given_up = 0;
    for (int i = 0; i < 20; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.2, 0.3, random);
      const View reference = look(test::furnishedRoom(), first, 360, 0.01, random);
      const View scan = look(test::furnishedRoom(), first * truth, 360, 0.01, random);
      const bool is_right = i % 2 == 0;
      const Pose2 guess = is_right ? spoil(truth, random) : test::randomPose(2.0, 3.1, random);
      const MatchResult in_full = patient.match({reference}, scan, guess);
      const MatchResult result = hasty.match({reference}, scan, guess);
      if (result.failure == MatchFailure::kNotConverged) {
        EXPECT_FALSE(is_right) << i;
        EXPECT_EQ(result.confidence, 0.0) << i;
        EXPECT_EQ(result.T_reference_scan.vector(), guess.vector()) << i;
        ++given_up;
      } else {
        EXPECT_EQ(result.confidence, in_full.confidence) << i;
        EXPECT_EQ(result.T_reference_scan.vector(), in_full.T_reference_scan.vector()) << i;
      }
    }
    EXPECT_GT(given_up, 5);
  }
}

/// Of 1000 matches with other seeds all were within these bounds.
TEST(PointToLineMatcherLaws, MatchesNoisyScansFromTwoPlaces) {
  const PointToLineMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.2, 0.3, random);
      const View reference = look(test::furnishedRoom(), first, 360, 0.01, random);
      const View scan = look(test::furnishedRoom(), first * truth, 360, 0.01, random);
      const auto result = matcher.match({reference}, scan, spoil(truth, random));
      const auto gap = test::gapBetween(result.T_reference_scan, truth);
      EXPECT_LT(gap.translation, 0.02) << i;
      EXPECT_LT(gap.rotation, 0.01) << i;
      EXPECT_EQ(result.failure, MatchFailure::kNone) << i;
    }
  }
}

/// From one place, with guesses farther off than partners may be in the end.
TEST(PointToLineMatcherLaws, FirstReachFindsTheWayFromFar) {
  const PointToLineMatcher matcher;
  int found = 0;
  int all = 0;
  for (const auto seed : test::seeds()) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
      const Pose2 place = test::randomPose(0.8, 3.1, random);
      const View reference = look(test::furnishedRoom(), place, 360, 0.01, random);
      const View scan = look(test::furnishedRoom(), place, 360, 0.01, random);
      const Pose2 guess = test::randomPose(0.25, 0.15, random);
      const auto gap =
          test::gapBetween(matcher.match({reference}, scan, guess).T_reference_scan, {});
      found += gap.translation < 0.02 && gap.rotation < 0.01 ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GE(found, 95 * all / 100) << found << " of " << all;
}

TEST(PointToLineMatcherLaws, ReferenceMayBeSeveralViews) {
  const PointToLineMatcher matcher;
  std::mt19937_64 random(6);
  const auto room = test::furnishedRoom();
  Reference reference;
  for (const double x : {-0.9, -0.6, -0.3, 0.0}) {
    const Pose2 place{x, 0.1, 0.2};
    reference.push_back(transformed(place, look(room, place, 90, 0.01, random)));
  }
  const Pose2 truth{0.3, 0.15, 0.3};
  const View scan = look(room, truth, 180, 0.01, random);
  const auto result = matcher.match(reference, scan, {0.38, 0.07, 0.37});
  EXPECT_LT(test::gapBetween(result.T_reference_scan, truth).translation, 0.01);
  EXPECT_LT(test::gapBetween(result.T_reference_scan, truth).rotation, 0.005);
}

TEST(PointToLineMatcherLaws, FrameOfTheReferenceDoesNotMatter) {
  const PointToLineMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const View reference = look(test::furnishedRoom(), {}, 360, 0.01, random);
    const View scan = look(test::furnishedRoom(), {0.1, 0.05, 0.05}, 360, 0.01, random);
    const Pose2 T_other_reference = test::randomPose(20.0, 3.1, random);
    const auto here = matcher.match({reference}, scan, {});
    const auto there =
        matcher.match({transformed(T_other_reference, reference)}, scan, T_other_reference);
    const auto gap =
        test::gapBetween(T_other_reference * here.T_reference_scan, there.T_reference_scan);
    EXPECT_LT(gap.translation, 1e-6);
    EXPECT_LT(gap.rotation, 1e-6);
    const Eigen::Matrix3d turned =
        geometry::rotateCovariance(here.covariance, T_other_reference.theta);
    EXPECT_LT((turned - there.covariance).norm(), 1e-6 * turned.norm());
    EXPECT_NEAR(here.residual, there.residual, 1e-9);
  }
}

/// The same two scans both ways: the results differ by less than the covariance allows.
TEST(PointToLineMatcherLaws, MatchingBackwardsIsTheInverse) {
  const PointToLineMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 10; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.2, 0.3, random);
      const View a = look(test::furnishedRoom(), first, 360, 0.01, random);
      const View b = look(test::furnishedRoom(), first * truth, 360, 0.01, random);
      const auto forth = matcher.match({a}, b, spoil(truth, random));
      const auto back = matcher.match({b}, a, spoil(truth, random).inverse());
      const Eigen::Matrix3d covariance = geometry::composeCovariance(
          forth.T_reference_scan, forth.covariance, back.T_reference_scan, back.covariance);
      EXPECT_LT(squaredMahalanobis(forth.T_reference_scan * back.T_reference_scan, covariance),
                14.16)
          << i;
    }
  }
}

TEST(PointToLineMatcherLaws, CorridorKeepsTheGuessAlongIt) {
  const PointToLineMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const View reference = look(test::endlessCorridor(), {}, 360, 0.01, random);
    const View scan = look(test::endlessCorridor(), {0.0, 0.2, 0.1}, 360, 0.01, random);
    const auto result = matcher.match({reference}, scan, {0.09, 0.15, 0.15});
    EXPECT_NEAR(result.T_reference_scan.x, 0.09, 1e-3);
    EXPECT_NEAR(result.T_reference_scan.y, 0.2, 0.01);
    EXPECT_NEAR(result.T_reference_scan.theta, 0.1, 0.01);
    EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
    EXPECT_TRUE(result.converged);
  }
}

TEST(PointToLineMatcherLaws, SameCallSameResult) {
  const PointToLineMatcher matcher;
  std::mt19937_64 random(2);
  const View reference = look(test::furnishedRoom(), {}, 180, 0.01, random);
  const View scan = look(test::furnishedRoom(), {0.1, 0.05, 0.05}, 180, 0.01, random);
  const auto first = matcher.match({reference}, scan, {});
  (void)matcher.match({scan}, reference, {0.2, 0.2, 0.2});
  const auto second = matcher.match({reference}, scan, {});
  EXPECT_EQ(first.T_reference_scan.vector(), second.T_reference_scan.vector());
  EXPECT_EQ(first.covariance, second.covariance);
}

}  // namespace
}  // namespace omega_slam::matching

#include "omega_slam/matching/correlative_matcher.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/covariance.h"
#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr double kThreeSigma = 14.16;  // of the squared Mahalanobis length, 3 degrees of freedom

View see(const test::Room& room, const Pose2& place, double noise, std::mt19937_64& random) {
  return {test::measurePoints(room, place, 360, noise, random), {0.0, 0.0}};
}

double squaredMahalanobis(const Pose2& T_a_b, const Pose2& truth,
                          const Eigen::Matrix3d& covariance) {
  const Eigen::Vector3d error(T_a_b.x - truth.x, T_a_b.y - truth.y,
                              geometry::angleDifference(T_a_b.theta, truth.theta));
  return error.dot(covariance.ldlt().solve(error));
}

/// A round room of 3 m around the origin.
test::Room roundRoom() {
  constexpr int kWalls = 180;
  const auto corner = [](int i) {
    const double angle = 2.0 * geometry::kPi * i / kWalls;
    return Eigen::Vector2d(3.0 * std::cos(angle), 3.0 * std::sin(angle));
  };
  test::Room room;
  for (int i = 0; i < kWalls; ++i) {
    room.walls.push_back({corner(i), corner(i + 1)});
  }
  return room;
}

TEST(CorrelativeMatcherLaws, RecoversDisplacementsOfAScanToMillimetres) {
  const CorrelativeMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 10; ++i) {
      const View reference =
          see(test::furnishedRoom(), test::randomPose(0.8, 3.1, random), 0.0, random);
      const Pose2 truth = test::randomPose(0.29, 0.34, random);
      const MatchResult result =
          matcher.match({reference}, transformed(truth.inverse(), reference), {});
      const auto gap = test::gapBetween(result.T_reference_scan, truth);
      EXPECT_LT(gap.translation, 1e-3) << i;
      EXPECT_LT(gap.rotation, 5e-4) << i;
      EXPECT_GT(result.confidence, 0.95) << i;
      EXPECT_EQ(result.failure, MatchFailure::kNone) << i;
    }
  }
}

TEST(CorrelativeMatcherLaws, GuessInTheWindowDoesNotMatter) {
  CorrelativeMatcherConfig config;
  config.window = {1.0, 0.6};
  const CorrelativeMatcher matcher(config);
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const View reference = see(test::furnishedRoom(), {}, 0.02, random);
    const Pose2 truth{0.3, -0.2, 0.4};
    const View scan = see(test::furnishedRoom(), truth, 0.02, random);
    for (int i = 0; i < 5; ++i) {
      const Pose2 guess =
          Pose2::fromVector(truth.vector() + test::randomPose(0.95, 0.55, random).vector());
      const auto gap =
          test::gapBetween(matcher.match({reference}, scan, guess).T_reference_scan, truth);
      EXPECT_LT(gap.translation, 0.01) << i;
      EXPECT_LT(gap.rotation, 0.005) << i;
    }
  }
}

TEST(CorrelativeMatcherLaws, TruthLiesWithinThreeSigma) {
  const CorrelativeMatcher matcher;
  int inside = 0;
  int trusted = 0;
  for (const auto seed : test::seeds()) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.3, 0.3, random);
      const View reference = see(test::furnishedRoom(), first, 0.02, random);
      const View scan = see(test::furnishedRoom(), first * truth, 0.02, random);
      const auto result =
          matcher.match({reference}, scan, truth * test::randomPose(0.1, 0.09, random));
      if (result.confidence >= 0.5) {
        ++trusted;
        const double squared =
            squaredMahalanobis(result.T_reference_scan, truth, result.covariance);
        inside += squared <= kThreeSigma ? 1 : 0;
        EXPECT_LT(std::sqrt(result.covariance.diagonal().maxCoeff()), 0.05) << "but not by bluff";
      }
    }
  }
  EXPECT_GE(trusted, 57 * static_cast<int>(test::seeds().size()) / 3);
  EXPECT_GE(inside, 97 * trusted / 100) << inside << " of " << trusted;
}

TEST(CorrelativeMatcherLaws, ThereAndBackIsTheIdentityWithinCovariance) {
  const CorrelativeMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 5; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.2, 0.2, random);
      const View a = see(test::furnishedRoom(), first, 0.01, random);
      const View b = see(test::furnishedRoom(), first * truth, 0.01, random);
      const MatchResult there = matcher.match({a}, b, {});
      const MatchResult back = matcher.match({b}, a, {});
      const Pose2 loop = there.T_reference_scan * back.T_reference_scan;
      const Eigen::Matrix3d covariance = geometry::composeCovariance(
          there.T_reference_scan, there.covariance, back.T_reference_scan, back.covariance);
      EXPECT_LE(squaredMahalanobis(loop, {}, covariance), kThreeSigma) << i;
      EXPECT_LT(test::gapBetween(loop, {}).translation, 0.03) << i;
    }
  }
}

TEST(CorrelativeMatcherLaws, FrameOfTheReferenceDoesNotMatter) {
  const CorrelativeMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const View reference = see(test::furnishedRoom(), {}, 0.0, random);
    const View scan = see(test::furnishedRoom(), {0.1, 0.05, 0.05}, 0.0, random);
    const auto here = matcher.match({reference}, scan, {});
    for (const double far : {10.0, 1e6}) {
      const Pose2 T_other_reference = test::randomPose(far, 3.1, random);
      const auto there =
          matcher.match({transformed(T_other_reference, reference)}, scan, T_other_reference);
      const auto gap =
          test::gapBetween(T_other_reference * here.T_reference_scan, there.T_reference_scan);
      EXPECT_LT(gap.translation, 1.5e-3) << far;
      EXPECT_LT(gap.rotation, 7e-4) << far;
    }
  }
}

TEST(CorrelativeMatcherLaws, ManyViewsMakeOneReference) {
  const CorrelativeMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const test::Room room = test::furnishedRoom();
    const Pose2 origin = test::randomPose(0.3, 3.1, random);
    Reference reference;
    for (int i = 0; i < 6; ++i) {
      // Half of the turn each, all around: no view alone has seen what the scan sees.
      Pose2 T_origin_view = test::randomPose(0.4, 0.2, random);
      T_origin_view.theta += geometry::kPi / 3.0 * i;
      View view = see(room, origin * T_origin_view, 0.01, random);
      view.points.resize(view.points.size() / 2);
      reference.push_back(transformed(T_origin_view, view));
    }
    const Pose2 truth = test::randomPose(0.4, 0.5, random);
    const View scan = see(room, origin * truth, 0.01, random);
    const auto result =
        matcher.match(reference, scan, truth * test::randomPose(0.15, 0.15, random));
    const auto gap = test::gapBetween(result.T_reference_scan, truth);
    EXPECT_LT(gap.translation, 0.01);
    EXPECT_LT(gap.rotation, 0.005);
    EXPECT_GT(result.overlap, 0.85);
  }
}

TEST(CorrelativeMatcherLaws, CorridorLeavesItsDirectionOpenAndTheGuessAlone) {
  const CorrelativeMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Pose2 place{0.0, 0.0, 0.7};
    const View reference = see(test::endlessCorridor(), place, 0.01, random);
    const View scan = see(test::endlessCorridor(), place, 0.01, random);
    const Pose2 guess = test::randomPose(0.15, 0.1, random);
    const auto result = matcher.match({reference}, scan, guess);
    EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
    ASSERT_TRUE(result.open_direction);
    const Eigen::Vector3d along(std::cos(-0.7), std::sin(-0.7), 0.0);
    EXPECT_NEAR(std::abs(result.open_direction->dot(along)), 1.0, 1e-2);
    EXPECT_GT(std::sqrt(along.dot(result.covariance * along)), 0.3);
    const Eigen::Vector3d moved = result.T_reference_scan.vector() - guess.vector();
    EXPECT_NEAR(moved.dot(along), 0.0, 0.06);
    const Eigen::Vector3d across(-along.y(), along.x(), 0.0);
    EXPECT_NEAR(result.T_reference_scan.vector().dot(across), 0.0, 0.01);
  }
}

TEST(CorrelativeMatcherLaws, ManyViewsOfACorridorDoNotLeadAstray) {
  CorrelativeMatcherConfig config;
  config.window = {1.0, 0.3};
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    Reference reference;  // of several keyframes, as loops are matched with
    for (const double x : {-1.5, -0.9, -0.3, 0.3, 0.9, 1.5}) {
      const Pose2 place{x, 0.0, 0.0};
      reference.push_back(transformed(place, see(test::endlessCorridor(), place, 0.01, random)));
    }
    const View scan = see(test::endlessCorridor(), {0.4, 0.0, 0.0}, 0.01, random);
    const auto result = CorrelativeMatcher(config).match(reference, scan, {0.4, 0.3, 0.1});
    EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
    EXPECT_NEAR(result.T_reference_scan.x, 0.4, 0.1) << "nothing says where along the corridor";
    EXPECT_NEAR(result.T_reference_scan.y, 0.0, 0.01);
  }
}

TEST(CorrelativeMatcherLaws, RoundRoomLeavesTheHeadingOpen) {
  const CorrelativeMatcher matcher;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const View reference = see(roundRoom(), {}, 0.01, random);
    const View scan = see(roundRoom(), {}, 0.01, random);
    const auto result = matcher.match({reference}, scan, {0.05, -0.1, 0.1});
    EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
    ASSERT_TRUE(result.open_direction);
    EXPECT_NEAR(std::abs(result.open_direction->z()), 1.0, 1e-2);
    EXPECT_GT(std::sqrt(result.covariance(2, 2)), 0.3);
    EXPECT_LT(result.T_reference_scan.translation().norm(), 0.02);
  }
}

TEST(CorrelativeMatcherLaws, PlacesThatLookAlikeAreAmbiguous) {
  // Two equal niches, 1.2 m apart, in a long wall.
  test::Room room;
  room.walls.push_back({{-20.0, -1.0}, {20.0, -1.0}});
  room.walls.push_back({{-20.0, 1.0}, {20.0, 1.0}});
  for (const double x : {-0.6, 0.6}) {
    room.addBox({x - 0.1, 0.6}, {x + 0.1, 1.0});
  }
  CorrelativeMatcherConfig config;
  config.window = {1.5, 0.1};
  const CorrelativeMatcher matcher(config);
  std::mt19937_64 random(1);
  const View reference = see(room, {}, 0.0, random);
  const auto alike = matcher.matchWithPeaks({reference}, reference, {}, 2);
  ASSERT_EQ(alike.peaks.size(), 2U);
  EXPECT_GT(alike.ambiguity(), 0.75);
  EXPECT_LT(test::gapBetween(alike.peaks[0].T_reference_scan, {}).translation, 0.02);
  const View distinct = see(test::furnishedRoom(), {}, 0.0, random);
  EXPECT_LT(matcher.matchWithPeaks({distinct}, distinct, {}, 2).ambiguity(), 0.6);
  EXPECT_EQ(matcher.matchWithPeaks({distinct}, distinct, {}, 1).ambiguity(), 0.0);
}

}  // namespace
}  // namespace omega_slam::matching

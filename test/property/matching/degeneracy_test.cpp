// Which directions a place leaves open, when the laser is noisy.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/matching/match_quality.h"
#include "omega_slam/matching/point_to_line_matcher.h"
#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr int kMatches = 15;  // a seed

/// A round room of 2.5 m radius around the origin, as a laser at a place sees it.
View lookRound(const Pose2& place, double noise, std::mt19937_64& random) {
  constexpr double kRadius = 2.5;
  std::normal_distribution<double> error(0.0, noise);
  View view;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * geometry::kPi / 180.0;
    const Eigen::Vector2d ray(std::cos(place.theta + angle), std::sin(place.theta + angle));
    const double along = place.translation().dot(ray);
    const double range =
        -along + std::sqrt(along * along + kRadius * kRadius - place.translation().squaredNorm());
    view.points.push_back((range + error(random)) *
                          Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return view;
}

void expectOpen(const MatchResult& result, const Eigen::Vector3d& direction) {
  EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
  ASSERT_TRUE(result.open_direction);
  EXPECT_NEAR(result.open_direction->norm(), 1.0, 1e-9);
  EXPECT_GT(std::abs(result.open_direction->dot(direction.normalized())), 0.99)
      << result.open_direction->transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(result.covariance);
  EXPECT_GT(std::sqrt(axes.eigenvalues()[2]), kOpenDeviation);
  EXPECT_LT(std::sqrt(axes.eigenvalues()[1]), 0.1) << "only one is open";
}

/// Matches two noisy looks at walls along x with each other and expects that x is open.
void expectOpenAlongX(const test::Room& room, double noise, std::mt19937_64& random) {
  const Pose2 first = test::randomPose(0.3, 3.1, random);
  const Pose2 truth = test::randomPose(0.3, 0.4, random);
  const View reference{test::measurePoints(room, first, 360, noise, random)};
  const View scan{test::measurePoints(room, first * truth, 360, noise, random)};
  const Pose2 error = test::randomPose(0.1, 0.08, random);
  const auto result = PointToLineMatcher().match(
      {reference}, scan, Pose2::fromVector(truth.vector() + error.vector()));
  expectOpen(result, {std::cos(first.theta), -std::sin(first.theta), 0.0});
}

TEST(DegeneracyLaws, CorridorLeavesItsDirectionOpen) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < kMatches; ++i) {
      expectOpenAlongX(test::endlessCorridor(), i % 2 == 0 ? 0.01 : 0.03, random);
    }
  }
}

TEST(DegeneracyLaws, SingleWallLeavesItsDirectionOpen) {
  test::Room room;
  room.walls.push_back({{-1000.0, 1.5}, {1000.0, 1.5}});
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < kMatches; ++i) {
      expectOpenAlongX(room, 0.02, random);
    }
  }
}

TEST(DegeneracyLaws, RoundRoomLeavesTheTurnAboutItsCenterOpen) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < kMatches; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.2, 0.3, random);
      const View reference = lookRound(first, 0.02, random);
      const View scan = lookRound(first * truth, 0.02, random);
      const auto result = PointToLineMatcher().match({reference}, scan, truth);
      const Eigen::Vector2d arm =
          result.T_reference_scan.translation() - first.inverse().translation();
      expectOpen(result, {-arm.y(), arm.x(), 1.0});
    }
  }
}

TEST(DegeneracyLaws, LonePostLeavesTheTurnAboutItOpen) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 0.02);
  View post;
  for (int i = 0; i < 40; ++i) {
    post.points.emplace_back(2.0 + noise(random), 1.0 + noise(random));
  }
  expectOpen(PointToLineMatcher().match({post}, post, {}), {1.0, -2.0, 1.0});
}

TEST(DegeneracyLaws, FarFromEverythingKnownAllIsOpen) {
  View ragged;  // points that form nothing
  std::mt19937_64 random(2);
  for (int i = 0; i < 40; ++i) {
    ragged.points.push_back(test::randomPose(8.0, 0.0, random).translation());
  }
  const auto result = PointToLineMatcher().match({ragged}, ragged, {0.02, 0.03, 0.0});
  EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(result.covariance);
  EXPECT_GT(std::sqrt(axes.eigenvalues()[0]), kOpenDeviation);
}

TEST(DegeneracyLaws, CorridorWithAnEndIsDetermined) {
  test::Room room = test::endlessCorridor();
  room.walls.push_back({{2.5, -1.0}, {2.5, 1.0}});
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < kMatches; ++i) {
      const Pose2 first = test::randomPose(0.3, 3.1, random);
      const Pose2 truth = test::randomPose(0.3, 0.4, random);
      const View reference{test::measurePoints(room, first, 360, 0.01, random)};
      const View scan{test::measurePoints(room, first * truth, 360, 0.01, random)};
      const auto result = PointToLineMatcher().match({reference}, scan, truth);
      EXPECT_EQ(result.failure, MatchFailure::kNone);
      EXPECT_FALSE(result.open_direction);
    }
  }
}

}  // namespace
}  // namespace omega_slam::matching

#include "omega_slam/matching/match_quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "support/room.h"

namespace omega_slam::matching {
namespace {

MatchResult judge(const Points& reference, const Points& scan,
                  const geometry::Pose2& T_reference_scan) {
  SurfaceModel model({View{reference}});
  return judgeMatch(model, View{scan}, T_reference_scan, {});
}

TEST(MatchQuality, PerfectMatchIsConfidentAndTight) {
  std::mt19937_64 random(1);
  const Points scan = test::measurePoints(test::furnishedRoom(), {}, 360, 0.0, random);
  const MatchResult result = judge(scan, scan, {});
  EXPECT_DOUBLE_EQ(result.overlap, 1.0);
  EXPECT_LT(result.residual, 2e-3) << "at corners the lines cut off a little";
  EXPECT_GT(result.confidence, 0.99);
  EXPECT_LT(std::sqrt(result.covariance(0, 0)), 0.02);
  EXPECT_LT(std::sqrt(result.covariance(2, 2)), 0.01);
  EXPECT_EQ(result.failure, MatchFailure::kNone);
}

TEST(MatchQuality, NoNumberOfPointsMakesItExact) {
  std::mt19937_64 random(1);
  const Points scan = test::measurePoints(test::furnishedRoom(), {}, 5000, 0.0, random);
  const MatchResult result = judge(scan, scan, {});
  EXPECT_GT(std::sqrt(result.covariance(0, 0)), 0.004);
  EXPECT_GT(std::sqrt(result.covariance(1, 1)), 0.004);
  EXPECT_GT(std::sqrt(result.covariance(2, 2)), 0.0015);
}

TEST(MatchQuality, WrongPoseIsLessConfident) {
  std::mt19937_64 random(1);
  const Points scan = test::measurePoints(test::furnishedRoom(), {}, 360, 0.01, random);
  const double right = judge(scan, scan, {}).confidence;
  EXPECT_LT(judge(scan, scan, {0.3, 0.0, 0.0}).confidence, right);
  EXPECT_LT(judge(scan, scan, {0.0, 0.0, 0.5}).confidence, 0.7 * right);
}

TEST(MatchQuality, FarApartThereIsNoOverlap) {
  std::mt19937_64 random(1);
  const Points scan = test::measurePoints(test::furnishedRoom(), {}, 90, 0.01, random);
  const MatchResult result = judge(scan, scan, {100.0, 0.0, 0.0});
  EXPECT_EQ(result.failure, MatchFailure::kNoOverlap);
  EXPECT_EQ(result.confidence, 0.0);
  EXPECT_TRUE(result.covariance.allFinite());
}

TEST(MatchQuality, CorridorLeavesItsDirectionOpen) {
  std::mt19937_64 random(1);
  const Points scan = test::measurePoints(test::endlessCorridor(), {}, 360, 0.01, random);
  const MatchResult result = judge(scan, scan, {});
  EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
  ASSERT_TRUE(result.open_direction);
  EXPECT_GT(std::abs(result.open_direction->x()), 0.99) << "along the corridor";
  EXPECT_GT(std::sqrt(result.covariance(0, 0)), 0.3) << "along the corridor";
  EXPECT_LT(std::sqrt(result.covariance(1, 1)), 0.02) << "across";
  EXPECT_LT(std::sqrt(result.covariance(2, 2)), 0.02);
}

TEST(MatchQuality, RoundRoomLeavesItsTurnOpen) {
  Points round;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * geometry::kPi / 180.0;
    round.emplace_back(3.0 * std::cos(angle), 3.0 * std::sin(angle));
  }
  const MatchResult result = judge(round, round, {});
  EXPECT_EQ(result.failure, MatchFailure::kDegenerate);
  ASSERT_TRUE(result.open_direction);
  EXPECT_GT(std::abs(result.open_direction->z()), 0.99);
  EXPECT_GT(std::sqrt(result.covariance(2, 2)), 0.3);
  EXPECT_LT(std::sqrt(result.covariance(0, 0)), 0.02);
}

TEST(MatchQuality, OtherSideOfAThinWallIsNoPartner) {
  Points wall;
  for (int i = 0; i < 100; ++i) {
    wall.emplace_back(-1.0 + 0.02 * i, 2.0);
  }
  SurfaceModel model({View{wall}});
  const View same_side{wall, {0.5, 0.0}};
  const View other_side{wall, {0.5, 4.0}};
  EXPECT_DOUBLE_EQ(judgeMatch(model, same_side, {}, {}).overlap, 1.0);
  EXPECT_EQ(judgeMatch(model, other_side, {}, {}).failure, MatchFailure::kNoOverlap);
}

TEST(MatchQuality, EmptyScanHasNoOverlap) {
  std::mt19937_64 random(1);
  const Points scan = test::measurePoints(test::furnishedRoom(), {}, 90, 0.01, random);
  EXPECT_EQ(judge(scan, {}, {}).failure, MatchFailure::kNoOverlap);
  EXPECT_EQ(judge({}, scan, {}).failure, MatchFailure::kNoOverlap);
}

}  // namespace
}  // namespace omega_slam::matching

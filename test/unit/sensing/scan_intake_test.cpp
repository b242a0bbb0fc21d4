#include "omega_slam/sensing/scan_intake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "omega_slam/geometry/angle.h"
#include "support/room.h"

namespace omega_slam::sensing {
namespace {

using geometry::kPi;
using geometry::Pose2;
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Beams at -90, 0 and 90 degrees.
LaserScan threeBeams(float right, float ahead, float left) {
  LaserScan scan;
  scan.stamp = 1.0;
  scan.angle_min = -kPi / 2.0;
  scan.angle_increment = kPi / 2.0;
  scan.range_min = 0.1;
  scan.range_max = 5.0;
  scan.ranges = {right, ahead, left};
  return scan;
}

ScanIntake intakeThatClears(double length, bool nan_is_no_return = false) {
  ScanIntakeConfig config;
  config.no_return_range = length;
  config.nan_is_no_return = nan_is_no_return;
  return ScanIntake(config);
}

TEST(ScanIntake, PutsBeamsIntoTheBaseFrame) {
  const auto result = ScanIntake({}).process(threeBeams(1.0F, 2.0F, 3.0F), {{0.5, 0.0, kPi / 2}});
  ASSERT_TRUE(result.sweep);
  EXPECT_TRUE(result.repairs.empty());
  const auto& beams = result.sweep->beams;
  ASSERT_EQ(beams.size(), 3U);
  EXPECT_TRUE(beams[0].end.isApprox(Eigen::Vector2d(1.5, 0.0), 1e-6));
  EXPECT_TRUE(beams[1].end.isApprox(Eigen::Vector2d(0.5, 2.0), 1e-6));
  EXPECT_TRUE(beams[2].end.isApprox(Eigen::Vector2d(-2.5, 0.0), 1e-6));
  EXPECT_EQ(result.sweep->returns().size(), 3U);
}

TEST(ScanIntake, ReadsRangesAsRep117Says) {
  const auto sweep = *intakeThatClears(2.0).process(threeBeams(kInf, -kInf, kNaN), {}).sweep;
  EXPECT_EQ(sweep.beams[0].kind, BeamKind::kNoReturn);
  EXPECT_NEAR(sweep.beams[0].end.norm(), 2.0, 1e-6);
  EXPECT_EQ(sweep.beams[1].kind, BeamKind::kUnknown);
  EXPECT_EQ(sweep.beams[2].kind, BeamKind::kUnknown);
}

TEST(ScanIntake, LimitsAreInclusiveAndTooCloseSaysNothing) {
  auto scan = threeBeams(0.05F, 5.0F, 5.1F);
  scan.range_min = 0.0625;  // exact in float
  const auto sweep = *intakeThatClears(9.0).process(scan, {}).sweep;
  EXPECT_EQ(sweep.beams[0].kind, BeamKind::kUnknown);
  EXPECT_EQ(sweep.beams[1].kind, BeamKind::kReturn);
  EXPECT_EQ(sweep.beams[2].kind, BeamKind::kNoReturn);
  EXPECT_NEAR(sweep.beams[2].end.norm(), 5.0, 1e-6) << "clears no farther than the laser sees";
}

TEST(ScanIntake, NaNMayMeanNoReturn) {
  const auto scan = threeBeams(1.0F, kNaN, 1.0F);
  EXPECT_EQ(intakeThatClears(2.0, true).process(scan, {}).sweep->beams[1].kind,
            BeamKind::kNoReturn);
  EXPECT_EQ(intakeThatClears(2.0, false).process(scan, {}).sweep->beams[1].kind,
            BeamKind::kUnknown);
}

TEST(ScanIntake, ZeroNoReturnRangeClearsNothing) {
  const auto sweep = *intakeThatClears(0.0).process(threeBeams(1.0F, kInf, 1.0F), {}).sweep;
  EXPECT_EQ(sweep.beams[1].kind, BeamKind::kUnknown);
}

TEST(ScanIntake, ConfiguredLimitTurnsFarReturnsIntoFreeSpace) {
  ScanIntakeConfig config;
  config.max_range = 2.0;
  config.no_return_range = 2.0;
  const auto sweep = *ScanIntake(config).process(threeBeams(1.0F, 3.0F, 1.0F), {}).sweep;
  EXPECT_EQ(sweep.beams[1].kind, BeamKind::kNoReturn);
  EXPECT_NEAR(sweep.beams[1].end.norm(), 2.0, 1e-6);
}

/// The same surroundings seen by a laser mounted in any way give the same points.
TEST(ScanIntake, MountingDoesNotMatter) {
  const test::Room room = test::furnishedRoom();
  std::mt19937_64 random(1);
  const Pose2 T_room_base{0.5, -0.3, 0.4};
  const Pose2 T_base_laser{0.1, 0.2, 2.0};
  const LaserScan upright = test::measure(room, T_room_base * T_base_laser, 90, 0.0, random);

  LaserScan clockwise = upright;  // the same beams, the last one first
  clockwise.angle_min = upright.angle_min + 89 * upright.angle_increment;
  clockwise.angle_increment = -upright.angle_increment;
  std::reverse(clockwise.ranges.begin(), clockwise.ranges.end());

  LaserScan upside_down = upright;  // beam at angle a is seen at -a
  upside_down.angle_min = -clockwise.angle_min;
  std::reverse(upside_down.ranges.begin(), upside_down.ranges.end());

  const ScanIntake intake{ScanIntakeConfig{}};
  const auto expected = *intake.process(upright, {T_base_laser, false}).sweep;
  const auto turned = intake.process(clockwise, {T_base_laser, false});
  const auto hanging = intake.process(upside_down, {T_base_laser, true});
  EXPECT_THAT(turned.repairs, testing::ElementsAre("sweeps clockwise"));
  for (std::size_t i = 0; i < expected.beams.size(); ++i) {
    EXPECT_LT((turned.sweep->beams[i].end - expected.beams[i].end).norm(), 1e-5) << i;
    EXPECT_LT((hanging.sweep->beams[i].end - expected.beams[i].end).norm(), 1e-5) << i;
  }
}

TEST(ScanIntake, TakesOutTheMotionDuringTheSweep) {
  const test::Room room = test::furnishedRoom();
  std::mt19937_64 random(1);
  const Pose2 T_room_start{0.2, 0.1, 0.3};
  const Pose2 motion{0.06, 0.01, 0.12};  // fast: 0.6 m/s and 1.2 rad/s at 10 Hz
  LaserScan moving = test::measure(room, T_room_start, 360, 0.0, random);
  moving.time_increment = 0.1 / 360.0;
  for (std::size_t i = 0; i < moving.ranges.size(); ++i) {
    const Pose2 T_room_base =
        T_room_start * interpolate(Pose2{}, motion, static_cast<double>(i) / 359.0);
    moving.ranges[i] = static_cast<float>(room.castRay(
        T_room_base.translation(),
        T_room_base.theta + moving.angle_min + static_cast<double>(i) * moving.angle_increment));
  }
  const ScanIntake intake{ScanIntakeConfig{}};
  const Pose2 T_room_middle = T_room_start * interpolate(Pose2{}, motion, 0.5);
  const auto farthestFromWalls = [&](const Sweep& sweep) {
    double farthest = 0.0;
    for (const Eigen::Vector2d& p_base : sweep.returns()) {
      const Eigen::Vector2d p = T_room_middle * p_base;
      const Eigen::Vector2d ray = p - T_room_middle.translation();
      const double to_wall = room.castRay(p - 0.3 * ray.normalized(), std::atan2(ray.y(), ray.x()));
      farthest = std::max(farthest, std::abs(to_wall - 0.3));
    }
    return farthest;
  };
  EXPECT_GT(farthestFromWalls(*intake.process(moving, {}).sweep), 0.05);
  const auto taken = intake.process(moving, {}, motion);
  EXPECT_LT(farthestFromWalls(*taken.sweep), 0.02);
  EXPECT_NEAR(taken.sweep->stamp, moving.stamp + 0.5 * 359.0 * moving.time_increment, 1e-12);
  EXPECT_LT(distance(T_room_start * taken.T_start_sweep, T_room_middle), 1e-12);
}

TEST(ScanIntake, AWrongMotionDuringTheSweepDoesNotTurnItAsAWhole) {
  const test::Room room = test::furnishedRoom();
  std::mt19937_64 random(1);
  LaserScan standing = test::measure(room, {0.2, 0.1, 0.3}, 360, 0.0, random);
  const ScanIntake intake{ScanIntakeConfig{}};
  const auto expected = *intake.process(standing, {}).sweep;
  standing.time_increment = 0.2 / 360.0;
  const auto turned = *intake.process(standing, {}, {0.0, 0.0, 0.1}).sweep;
  double turn = 0.0;
  for (std::size_t i = 0; i < turned.beams.size(); ++i) {
    const Eigen::Vector2d& was = expected.beams[i].end;
    const Eigen::Vector2d& is = turned.beams[i].end;
    turn += std::atan2(was.x() * is.y() - was.y() * is.x(), was.dot(is));
  }
  EXPECT_NEAR(turn / static_cast<double>(turned.beams.size()), 0.0, 0.001);
}

TEST(ScanIntake, ASweepThatTakesNoTimeStandsForItsStamp) {
  const LaserScan scan = threeBeams(1.0F, 1.0F, 1.0F);
  const auto taken = ScanIntake({}).process(scan, {}, {0.1, 0.0, 0.1});
  EXPECT_EQ(taken.sweep->stamp, scan.stamp);
  EXPECT_EQ(taken.T_start_sweep.vector(), Eigen::Vector3d::Zero());
}

TEST(ScanIntake, AcceptsAnyCountOfBeams) {
  const ScanIntake intake{ScanIntakeConfig{}};
  for (const std::size_t count : {1U, 3U, 4U, 5U}) {
    auto scan = threeBeams(1.0F, 1.0F, 1.0F);
    scan.ranges.assign(count, 1.0F);
    EXPECT_TRUE(intake.process(scan, {}).sweep) << count;
  }
}

TEST(ScanIntake, TheRobotsOwnPostsAreNoWalls) {
  const auto sweep = *ScanIntake({}).process(threeBeams(0.15F, 0.25F, 0.19F), {}).sweep;
  EXPECT_EQ(sweep.beams[0].kind, BeamKind::kUnknown);
  EXPECT_EQ(sweep.beams[1].kind, BeamKind::kReturn);
  EXPECT_EQ(sweep.beams[2].kind, BeamKind::kUnknown);
}

TEST(ScanIntake, ConfigurationIsChecked) {
  ScanIntakeConfig config;
  config.min_range = -1.0;
  config.min_beams = 0;
  EXPECT_EQ(config.validate().size(), 2U);
  EXPECT_THROW(ScanIntake{config}, std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::sensing

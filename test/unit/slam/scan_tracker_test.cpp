#include "omega_slam/slam/scan_tracker.h"

#include <gtest/gtest.h>

#include <random>

#include "support/poses.h"
#include "support/room.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;

constexpr double kMinConfidence = 0.5;

matching::View viewAt(const Pose2& T_room_base, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return {test::measurePoints(test::furnishedRoom(), T_room_base, 360, 0.01, random), {0.0, 0.0}};
}

matching::LocalMap mapOfTheRoom() {
  matching::LocalMap map;
  for (std::uint64_t i = 0; i < 8; ++i) {
    const Pose2 pose{-0.4 + 0.1 * static_cast<double>(i), 0.2, 0.3};
    (void)map.insert(viewAt(pose, i), pose);
  }
  return map;
}

Belief surelyAt(const Pose2& pose) { return {pose, Eigen::Matrix3d::Zero()}; }

OdometryStep stepOf(const Pose2& motion, double deviation) {
  return {motion, deviation * deviation * Eigen::Matrix3d::Identity()};
}

TEST(ScanTracker, FusesPredictionAndMatch) {
  const ScanTracker tracker({}, kMinConfidence);
  const Pose2 truth{0.1, 0.25, 0.35};
  const auto tracked = tracker.track(mapOfTheRoom(), viewAt(truth, 50), surelyAt({0.0, 0.2, 0.3}),
                                     stepOf({0.12, 0.03, 0.06}, 0.03));
  ASSERT_TRUE(tracked.is_trusted);
  EXPECT_FALSE(tracked.has_slipped);
  EXPECT_LT(test::gapBetween(tracked.belief.pose, truth).translation, 0.01);
  EXPECT_LT(test::gapBetween(tracked.belief.pose, truth).rotation, 0.005);
  EXPECT_LT(tracked.belief.covariance.trace(), tracked.match.covariance.trace());
}

TEST(ScanTracker, WhatTheMatchContradictsIsASlip) {
  const ScanTracker tracker({}, kMinConfidence);
  const Pose2 truth{0.0, 0.2, 0.3};  // the wheels turned on the spot
  const auto tracked = tracker.track(mapOfTheRoom(), viewAt(truth, 51), surelyAt(truth),
                                     stepOf({0.15, 0.0, 0.0}, 0.005));
  ASSERT_TRUE(tracked.is_trusted);
  EXPECT_TRUE(tracked.has_slipped);
  EXPECT_LT(test::gapBetween(tracked.belief.pose, truth).translation, 0.01);
}

TEST(ScanTracker, WithoutAMatchTheOdometryCarriesOn) {
  const ScanTracker tracker({}, kMinConfidence);
  const auto tracked =
      tracker.track(mapOfTheRoom(), {}, surelyAt({1.0, 2.0, 0.0}), stepOf({0.1, 0.0, 0.2}, 0.02));
  EXPECT_FALSE(tracked.is_trusted);
  EXPECT_NEAR(tracked.belief.pose.x, 1.1, 1e-12);
  EXPECT_NEAR(tracked.belief.pose.theta, 0.2, 1e-12);
  EXPECT_NEAR(tracked.belief.covariance(2, 2), 0.02 * 0.02, 1e-12);
}

TEST(ScanTracker, WhereTheScanFitsAsWellAsPredictedItIsNoSlip) {
  // A bare wall says nothing of the way along it, whatever a match makes of that.
  test::Room wall;
  wall.walls.push_back({{-50.0, 1.0}, {50.0, 1.0}});
  matching::LocalMap map;
  for (std::uint64_t i = 0; i < 8; ++i) {
    std::mt19937_64 random(i);
    const Pose2 pose{0.1 * static_cast<double>(i), 0.0, 0.0};
    (void)map.insert({test::measurePoints(wall, pose, 360, 0.01, random), {0.0, 0.0}}, pose);
  }
  const ScanTracker tracker({}, kMinConfidence);
  std::mt19937_64 random(9);
  const Pose2 truth{0.9, 0.0, 0.0};
  const auto tracked =
      tracker.track(map, {test::measurePoints(wall, truth, 360, 0.01, random), {0.0, 0.0}},
                    surelyAt({0.7, 0.0, 0.0}), stepOf({0.2, 0.0, 0.0}, 0.002));
  EXPECT_FALSE(tracked.has_slipped);
  EXPECT_LT(test::gapBetween(tracked.belief.pose, truth).translation, 0.02);
}

TEST(ScanTracker, ARobotThatWasTurnedIsFoundByALookAround) {
  const ScanTracker tracker({}, kMinConfidence);
  const matching::LocalMap map = mapOfTheRoom();
  const Pose2 truth{0.6, -0.4, 2.2};
  const auto scan = viewAt(truth, 60);
  const auto tracked = tracker.track(map, scan, surelyAt({0.0, 0.2, 0.3}), stepOf({}, 0.01));
  ASSERT_TRUE(tracked.is_contradicted);
  EXPECT_FALSE(tracked.is_trusted);
  EXPECT_LT(test::gapBetween(tracked.belief.pose, {0.0, 0.2, 0.3}).translation, 1e-9);
  const auto recovered = tracker.recover(map, scan, tracked);
  ASSERT_TRUE(recovered.is_trusted);
  EXPECT_FALSE(recovered.is_contradicted);
  EXPECT_LT(test::gapBetween(recovered.belief.pose, truth).translation, 0.03);
  EXPECT_LT(test::gapBetween(recovered.belief.pose, truth).rotation, 0.02);
}

TEST(ScanTracker, WhatIsNotThereIsNotFound) {
  const ScanTracker tracker({}, kMinConfidence);
  const matching::LocalMap map = mapOfTheRoom();
  test::Room other;
  other.addBox({-1.0, -1.2}, {1.5, 0.8});
  std::mt19937_64 random(1);
  const matching::View scan{test::measurePoints(other, {}, 360, 0.01, random), {0.0, 0.0}};
  const auto tracked = tracker.track(map, scan, surelyAt({0.0, 0.2, 0.3}), stepOf({}, 0.01));
  ASSERT_TRUE(tracked.is_contradicted);
  EXPECT_TRUE(tracker.recover(map, scan, tracked).is_contradicted);
}

}  // namespace
}  // namespace omega_slam::slam

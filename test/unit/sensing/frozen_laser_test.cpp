#include "omega_slam/sensing/frozen_laser.h"

#include <gtest/gtest.h>

#include <limits>

namespace omega_slam::sensing {
namespace {

using Ranges = std::vector<float>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(FrozenLaser, ARobotThatStandsMaySeeTheSameTwice) {
  FrozenLaser laser;
  EXPECT_FALSE(laser.repeats({1.0F, 2.0F}, {}));
  EXPECT_FALSE(laser.repeats({1.0F, 2.0F}, {0.001, 0.0, 0.0}));
}

TEST(FrozenLaser, OneThatMovesMayNot) {
  for (const geometry::Pose2& moved : {geometry::Pose2{0.05, 0.0, 0.0}, {0.0, 0.0, -0.05}}) {
    FrozenLaser laser;
    EXPECT_FALSE(laser.repeats({1.0F, kNan, 2.0F}, {}));
    EXPECT_TRUE(laser.repeats({1.0F, kNan, 2.0F}, moved));
    EXPECT_FALSE(laser.repeats({1.1F, kNan, 2.0F}, moved));
  }
}

TEST(FrozenLaser, SmallStepsAddUp) {
  FrozenLaser laser;
  const Ranges ranges{3.0F};
  int repeats = 0;
  for (int i = 0; i < 10; ++i) {
    repeats += laser.repeats(ranges, {0.005 * i, 0.0, 0.0}) ? 1 : 0;
  }
  EXPECT_EQ(repeats, 5);
}

TEST(FrozenLaser, AnotherNumberOfBeamsIsAnotherScan) {
  FrozenLaser laser;
  EXPECT_FALSE(laser.repeats({1.0F, 2.0F}, {}));
  EXPECT_FALSE(laser.repeats({1.0F}, {1.0, 0.0, 0.0}));
  EXPECT_FALSE(laser.repeats({}, {2.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace omega_slam::sensing

#include "omega_slam/simulation/kobuki.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "omega_slam/geometry/angle.h"
#include "support/drawn_world.h"

namespace omega_slam::simulation {
namespace {

using geometry::kPi;

constexpr double kStep = 0.02;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Drives on with the same command, given anew at every step.
void drive(Kobuki& kobuki, const World& world, const Twist2& command, double seconds) {
  for (int i = 0; i < std::lround(seconds / kStep); ++i) {
    ASSERT_TRUE(kobuki.command(command));
    kobuki.step(world, kStep);
  }
}

class KobukiTest : public ::testing::Test {
 protected:
  std::shared_ptr<const World> room_ = test::emptyRoom(10.0);
  KobukiConfig config_;
  Kobuki kobuki_{config_, {}};
};

TEST_F(KobukiTest, StandsWithoutACommand) {
  for (int i = 0; i < 100; ++i) {
    kobuki_.step(*room_, kStep);
  }
  EXPECT_EQ(kobuki_.pose().vector(), Eigen::Vector3d::Zero());
}

TEST_F(KobukiTest, AcceleratesSteadilyToTheCommandedSpeed) {
  const double v = 0.4;
  const double ramp = v / config_.max_linear_acceleration;
  ASSERT_DOUBLE_EQ(ramp, 0.5);
  drive(kobuki_, *room_, {v, 0.0}, 2.0);
  EXPECT_DOUBLE_EQ(kobuki_.velocity().linear, v);
  EXPECT_NEAR(kobuki_.pose().x, 0.5 * v * ramp + v * (2.0 - ramp), 1e-9);
  EXPECT_EQ(kobuki_.pose().y, 0.0);
}

TEST_F(KobukiTest, KeepsToItsSpeedLimits) {
  drive(kobuki_, *room_, {5.0, -50.0}, 3.0);
  EXPECT_DOUBLE_EQ(kobuki_.velocity().linear, config_.max_linear_speed);
  EXPECT_DOUBLE_EQ(kobuki_.velocity().angular, -config_.max_angular_speed);
  drive(kobuki_, *room_, {-5.0, 50.0}, 3.0);
  EXPECT_DOUBLE_EQ(kobuki_.velocity().linear, -config_.max_linear_speed);
  EXPECT_DOUBLE_EQ(kobuki_.velocity().angular, config_.max_angular_speed);
}

TEST_F(KobukiTest, NeverExceedsItsAccelerations) {
  Twist2 before;
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(kobuki_.command(i % 30 < 15 ? Twist2{0.7, 3.0} : Twist2{-0.7, -3.0}));
    kobuki_.step(*room_, kStep);
    const Twist2 now = kobuki_.velocity();
    EXPECT_LE(std::abs(now.linear - before.linear),
              config_.max_linear_acceleration * kStep + 1e-12);
    EXPECT_LE(std::abs(now.angular - before.angular),
              config_.max_angular_acceleration * kStep + 1e-12);
    before = now;
  }
}

TEST_F(KobukiTest, DrivesAFullCircleBackToItsPlace) {
  const double v = 0.3;
  const double w = 0.5;
  drive(kobuki_, *room_, {v, w}, 1.0);  // up to speed
  const geometry::Pose2 start = kobuki_.pose();
  const double period = 2.0 * kPi / w;
  const int steps = static_cast<int>(period / kStep);
  drive(kobuki_, *room_, {v, w}, steps * kStep);
  ASSERT_TRUE(kobuki_.command({v, w}));
  kobuki_.step(*room_, period - steps * kStep);
  EXPECT_NEAR(geometry::distance(kobuki_.pose(), start), 0.0, 1e-9);
  EXPECT_NEAR(geometry::angleDifference(kobuki_.pose().theta, start.theta), 0.0, 1e-9);
}

TEST_F(KobukiTest, TurnsOnTheSpot) {
  drive(kobuki_, *room_, {0.0, 1.0}, 2.0);
  const double ramp = 1.0 / config_.max_angular_acceleration;
  EXPECT_EQ(kobuki_.pose().translation().norm(), 0.0);
  EXPECT_NEAR(kobuki_.pose().theta, 2.0 - 0.5 * ramp, 0.5 * kStep * kStep * 3.5);
}

TEST_F(KobukiTest, BrakesOnceTheLastCommandIsTooOld) {
  drive(kobuki_, *room_, {0.4, 0.0}, 1.0);
  // The command of the last step was already one step old after it.
  const int fresh = static_cast<int>(std::lround(config_.command_timeout / kStep)) - 1;
  for (int i = 0; i < fresh; ++i) {
    kobuki_.step(*room_, kStep);
    ASSERT_DOUBLE_EQ(kobuki_.velocity().linear, 0.4) << "after " << i << " steps";
  }
  kobuki_.step(*room_, kStep);
  EXPECT_LT(kobuki_.velocity().linear, 0.4);
  for (int i = 0; i < 30; ++i) {
    kobuki_.step(*room_, kStep);
  }
  EXPECT_EQ(kobuki_.velocity().linear, 0.0);
}

TEST_F(KobukiTest, IgnoresCommandsThatAreNoNumbers) {
  drive(kobuki_, *room_, {0.4, 0.0}, 1.0);
  for (const Twist2& bad :
       {Twist2{kNan, 0.0}, Twist2{0.0, kNan}, Twist2{kInfinity, 0.0}, Twist2{0.0, -kInfinity}}) {
    EXPECT_FALSE(kobuki_.command(bad));
  }
  kobuki_.step(*room_, kStep);
  EXPECT_DOUBLE_EQ(kobuki_.velocity().linear, 0.4);
}

TEST_F(KobukiTest, StopsWhereItsFootprintTouchesTheWall) {
  const auto small = test::emptyRoom(1.0);
  drive(kobuki_, *small, {0.5, 0.0}, 4.0);
  EXPECT_NEAR(kobuki_.pose().x, 1.0 - config_.radius, 1e-5);
  EXPECT_LE(kobuki_.pose().x, 1.0 - config_.radius + 1e-8);
  EXPECT_EQ(kobuki_.velocity().linear, 0.0);
  EXPECT_TRUE(kobuki_.blocked());
}

/// Drives straight into a wall that lies in the direction `bearing` from the robot's nose.
Bumper bumpAt(double bearing) {
  const auto room = test::emptyRoom(1.0);
  Kobuki kobuki(KobukiConfig{}, {1.0 - KobukiConfig{}.radius - 0.05, 0.0, -bearing});
  const bool forward = std::cos(bearing) > 0.0;
  drive(kobuki, *room, {forward ? 0.5 : -0.5, 0.0}, 4.0);
  EXPECT_TRUE(kobuki.blocked());
  return kobuki.bumper();
}

TEST(KobukiBumper, TellsTheSideOfTheContact) {
  EXPECT_EQ(bumpAt(0.0), (Bumper{false, true, false}));
  EXPECT_EQ(bumpAt(0.45), (Bumper{false, true, false}));
  EXPECT_EQ(bumpAt(0.6), (Bumper{true, false, false}));
  EXPECT_EQ(bumpAt(-0.6), (Bumper{false, false, true}));
  EXPECT_EQ(bumpAt(1.4), (Bumper{true, false, false}));
}

TEST(KobukiBumper, HasNoSwitchBehind) {
  EXPECT_EQ(bumpAt(kPi), Bumper{});
  EXPECT_EQ(bumpAt(2.5), Bumper{});
}

TEST(KobukiBumper, LetsGoWhenTheRobotBacksOff) {
  const auto room = test::emptyRoom(1.0);
  Kobuki kobuki(KobukiConfig{}, {0.7, 0.0, 0.0});
  drive(kobuki, *room, {0.3, 0.0}, 2.0);
  ASSERT_TRUE(kobuki.bumper().centre);
  drive(kobuki, *room, {-0.3, 0.0}, 1.0);
  EXPECT_FALSE(kobuki.bumper().any());
  EXPECT_LT(kobuki.pose().x, 0.7);
}

TEST(KobukiBumper, TheRobotTurnsFreelyAtTheWall) {
  const auto room = test::emptyRoom(1.0);
  Kobuki kobuki(KobukiConfig{}, {0.7, 0.0, 0.0});
  drive(kobuki, *room, {0.3, 0.0}, 2.0);
  drive(kobuki, *room, {0.0, 1.0}, 2.0);
  EXPECT_GT(kobuki.pose().theta, 1.5);
  EXPECT_FALSE(kobuki.bumper().centre);
}

TEST(KobukiBumper, GlassStopsTheRobotToo) {
  const auto world = test::drawnWorld({"......g...", "......g...", "......g..."}, 0.5);
  Kobuki kobuki(KobukiConfig{}, {1.0, 0.75, 0.0});
  drive(kobuki, *world, {0.5, 0.0}, 8.0);
  EXPECT_NEAR(kobuki.pose().x, 3.0 - KobukiConfig{}.radius, 1e-5);
}

TEST(KobukiPlace, StandsStillAtTheNewPlace) {
  const auto room = test::emptyRoom(5.0);
  Kobuki kobuki(KobukiConfig{}, {});
  drive(kobuki, *room, {0.5, 0.5}, 2.0);
  kobuki.place({1.0, 2.0, 0.5});
  kobuki.step(*room, kStep);
  EXPECT_EQ(kobuki.pose().vector(), Eigen::Vector3d(1.0, 2.0, 0.5));
}

TEST(KobukiConfiguration, NamesEveryViolation) {
  KobukiConfig config;
  EXPECT_TRUE(config.validate().empty());
  config.radius = 0.0;
  config.command_timeout = kNan;
  EXPECT_THAT(config.validate(), ::testing::ElementsAre(::testing::HasSubstr("radius"),
                                                        ::testing::HasSubstr("command_timeout")));
  EXPECT_THROW(Kobuki(config, {}), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::simulation

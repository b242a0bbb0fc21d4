#include "omega_slam/simulation/route_driver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "omega_slam/simulation/turtlebot.h"
#include "support/drawn_world.h"

namespace omega_slam::simulation {
namespace {

using Route = std::vector<Eigen::Vector2d>;

/// Drives until the route is done, stuck, or the time is up.
RouteStatus driveRoute(TurtleBot& robot, RouteDriver& driver, double seconds) {
  while (driver.status().state == RouteStatus::State::kDriving && robot.time() < seconds) {
    EXPECT_TRUE(robot.command(driver.update(robot.time(), robot.truth().T_world_base)));
    robot.step();
  }
  return driver.status();
}

TEST(RouteDriver, VisitsItsWaypointsInTurn) {
  TurtleBot robot(test::emptyRoom(3.0), {}, {});
  RouteDriver driver({}, Route{{2.0, 0.0}, {2.0, 2.0}, {-2.0, -1.0}});
  EXPECT_EQ(driver.status().toString(), "driving 1/3");
  EXPECT_EQ(driveRoute(robot, driver, 60.0).toString(), "done");
  EXPECT_NEAR(robot.truth().T_world_base.x, -2.0, 0.12);
  EXPECT_NEAR(robot.truth().T_world_base.y, -1.0, 0.12);
}

TEST(RouteDriver, KeepsNearTheLineBetweenWaypoints) {
  TurtleBot robot(test::emptyRoom(3.0), {}, {});
  RouteDriver driver({}, Route{{2.0, 0.0}, {2.0, 2.0}});
  while (driver.status().state == RouteStatus::State::kDriving && robot.time() < 60.0) {
    EXPECT_TRUE(robot.command(driver.update(robot.time(), robot.truth().T_world_base)));
    const geometry::Pose2 pose = robot.step().truth.T_world_base;
    EXPECT_LT(std::min(std::abs(pose.y), std::abs(pose.x - 2.0)), 0.10);
  }
}

TEST(RouteDriver, KeepsToItsSpeeds) {
  RouteDriverConfig config;
  config.max_linear_speed = 0.3;
  config.max_angular_speed = 0.8;
  TurtleBot robot(test::emptyRoom(4.0), {0.0, 0.0, 2.0}, {});
  RouteDriver driver(config, Route{{3.0, 0.0}, {3.0, 3.0}, {-3.0, 3.0}});
  double fastest = 0.0;
  while (driver.status().state == RouteStatus::State::kDriving && robot.time() < 90.0) {
    const Twist2 twist = driver.update(robot.time(), robot.truth().T_world_base);
    EXPECT_LE(std::abs(twist.linear), 0.3);
    EXPECT_LE(std::abs(twist.angular), 0.8);
    fastest = std::max(fastest, twist.linear);
    EXPECT_TRUE(robot.command(twist));
    robot.step();
  }
  EXPECT_EQ(driver.status().toString(), "done");
  EXPECT_GT(fastest, 0.29);
}

TEST(RouteDriver, TurnsOnTheSpotWhereTheCourseIsFarOff) {
  RouteDriver driver({}, Route{{-2.0, 0.1}});
  const Twist2 twist = driver.update(0.0, {});
  EXPECT_EQ(twist.linear, 0.0);
  EXPECT_GT(twist.angular, 0.0);
}

TEST(RouteDriver, SlowsDownForASharpCornerOnly) {
  const auto speedBefore = [](const Eigen::Vector2d& after_corner) {
    RouteDriver driver({}, Route{{1.0, 0.0}, after_corner});
    EXPECT_GT(driver.update(0.0, {}).linear, 0.0);
    return driver.update(0.1, {0.85, 0.0, 0.0}).linear;
  };
  EXPECT_LT(speedBefore({1.0, 1.0}), 0.32);
  EXPECT_NEAR(speedBefore({2.0, 0.0}), RouteDriverConfig{}.max_linear_speed, 1e-9);
}

TEST(RouteDriver, BacksOffFromABumpAndGivesUpInTheEnd) {
  TurtleBot robot(test::emptyRoom(1.0), {}, {});
  RouteDriver driver({}, Route{{5.0, 0.0}});  // behind the wall
  bool backed_off = false;
  while (driver.status().state == RouteStatus::State::kDriving && robot.time() < 120.0) {
    const Twist2 twist = driver.update(robot.time(), robot.truth().T_world_base);
    backed_off = backed_off || twist.linear < 0.0;
    EXPECT_TRUE(robot.command(twist));
    robot.step();
  }
  EXPECT_TRUE(backed_off);
  EXPECT_THAT(driver.status().toString(),
              ::testing::MatchesRegex("stuck: waypoint 1 at \\(5.00, 0.00\\) cannot be reached.*"));
  EXPECT_EQ(robot.collisions(), RouteDriverConfig{}.max_bumps + 1);
}

TEST(RouteDriver, StopsWhenItIsDone) {
  RouteDriver driver({}, Route{{0.05, 0.0}});
  const Twist2 twist = driver.update(0.0, {});
  EXPECT_EQ(twist.linear, 0.0);
  EXPECT_EQ(twist.angular, 0.0);
  EXPECT_EQ(driver.status().toString(), "done");
}

TEST(RouteDriver, AnEmptyRouteIsDone) {
  RouteDriver driver({}, {});
  EXPECT_EQ(driver.status().toString(), "done");
  EXPECT_EQ(driver.update(0.0, {}).linear, 0.0);
}

TEST(RouteDriver, ALongPauseIsABumpButTimeThatGoesBackIsNot) {
  RouteDriver driver({}, Route{{2.0, 0.0}});
  EXPECT_GT(driver.update(100.0, {}).linear, 0.0);
  EXPECT_GT(driver.update(5.0, {}).linear, 0.0);
  EXPECT_GT(driver.update(6.0, {}).linear, 0.0);
  EXPECT_EQ(driver.update(7.0, {}).linear, 0.0);
  EXPECT_LT(driver.update(7.1, {}).linear, 0.0);
}

TEST(RouteDriver, RefusesWaypointsThatAreNoNumbers) {
  EXPECT_THROW(RouteDriver({}, Route{{std::numeric_limits<double>::quiet_NaN(), 0.0}}),
               std::invalid_argument);
}

TEST(RouteDriverConfiguration, NamesEveryViolation) {
  RouteDriverConfig config;
  EXPECT_TRUE(config.validate().empty());
  config.look_ahead = 0.0;
  config.max_bumps = -1;
  EXPECT_THAT(config.validate(), ::testing::ElementsAre(::testing::HasSubstr("look_ahead"),
                                                        ::testing::HasSubstr("max_bumps")));
  EXPECT_THROW(RouteDriver(config, {}), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::simulation

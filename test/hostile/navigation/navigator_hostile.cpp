#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "omega_slam/navigation/navigator.h"
#include "support/drawn_map.h"

namespace omega_slam::navigation {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Footprint kRobot{0.18, 0.2};

grid::OccupancyGrid openRoom() {
  return test::drawnMap({"######", "#    #", "#    #", "#    #", "######"}, 0.05, 10);
}

TEST(NavigatorHostile, NumbersThatAreNoneNeverReachTheWheels) {
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e300}) {
    Navigator navigator({}, kRobot);
    navigator.setMap(openRoom());
    Sighting sighting{1.0, {bad, 0.0}, {{bad, 1.0}, {1.0, bad}}, {{bad, bad}}};
    navigator.see(sighting, {1.0, 1.0, 0.0});
    sighting.origin = {0.0, 0.0};
    navigator.see(sighting, {1.0, 1.0, 0.0});
    navigator.see(sighting, {bad, 1.0, 0.0});
    navigator.touch({{bad, 0.0}}, 1.0);
    navigator.setGoal({{bad, 1.0}, bad}, 1.0);
    for (int i = 1; i < 30; ++i) {
      const geometry::StampedPose2 pose{1.0 + 0.1 * i, {i % 2 == 0 ? bad : 1.0, 1.0, 0.0}};
      const NavigatorStep step = navigator.step(pose.stamp, pose, {bad, bad});
      EXPECT_TRUE(std::isfinite(step.velocity.linear) && std::isfinite(step.velocity.angular));
    }
    EXPECT_FALSE(navigator.plan({bad, 1.0}, {1.0, 1.0}).found());
    EXPECT_FALSE(navigator.plan({1.0, 1.0}, {1.0, bad}).found());
  }
}

TEST(NavigatorHostile, MapsWithoutRoom) {
  for (const std::int8_t value : {grid::kOccupied, grid::kUnknown}) {
    for (const int size : {1, 2, 40}) {
      Navigator navigator({}, kRobot);
      navigator.setMap(grid::makeGrid({0.05, {0.0, 0.0}, size, size}, value));
      EXPECT_FALSE(navigator.plan({0.02, 0.02}, {0.03, 0.03}).found());
    }
  }
  Navigator navigator({}, kRobot);
  navigator.setMap({});
  EXPECT_EQ(navigator.plan({0.0, 0.0}, {0.1, 0.0}).status, PlanStatus::kNoMap);
}

TEST(NavigatorHostile, AGoalWhereTheRobotStandsIsReached) {
  Navigator navigator({}, kRobot);
  navigator.setMap(openRoom());
  navigator.see({1.0, {0.0, 0.0}, {}, {}}, {1.2, 1.2, 0.0});
  navigator.setGoal({{1.2, 1.2}, std::nullopt}, 1.0);
  const NavigatorStep step =
      navigator.step(1.1, geometry::StampedPose2{1.1, {1.2, 1.2, 0.0}}, {0.0, 0.0});
  EXPECT_EQ(step.state, NavigationState::kReached) << step.reason;
}

TEST(NavigatorHostile, AMapThatVanishesUnderARunningGoal) {
  Navigator navigator({}, kRobot);
  navigator.setMap(openRoom());
  navigator.setGoal({{2.2, 1.2}, std::nullopt}, 1.0);
  NavigatorStep step;
  for (int i = 1; i < 300; ++i) {
    const double now = 1.0 + 0.1 * i;
    if (i == 10) {
      navigator.setMap(grid::makeGrid({0.05, {50.0, 50.0}, 3, 3}, grid::kUnknown));
    }
    navigator.see({now, {0.0, 0.0}, {{1.0, 0.0}}, {}}, {1.2, 1.2, 0.0});
    step = navigator.step(now, geometry::StampedPose2{now, {1.2, 1.2, 0.0}}, {0.0, 0.0});
    if (step.state == NavigationState::kFailed) {
      break;
    }
  }
  EXPECT_EQ(step.state, NavigationState::kFailed);
  EXPECT_FALSE(step.reason.empty());
}

TEST(NavigatorHostile, WrongConfigurationsSayAllThatIsWrong) {
  NavigatorConfig config;
  config.follower.max_linear_speed = kNan;
  config.recovery.turn_speed = 0.0;
  config.costmap.reach = -1.0;
  config.margin = kInfinity;
  EXPECT_EQ(config.validate().size(), 4U);
  EXPECT_THROW(Navigator(config, kRobot), std::invalid_argument);
  EXPECT_THROW(Navigator({}, {0.0, kNan}), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::navigation

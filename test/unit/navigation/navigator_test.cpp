#include "omega_slam/navigation/navigator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "omega_slam/motion/arc.h"
#include "support/drawn_map.h"

namespace omega_slam::navigation {
namespace {

constexpr double kStep = 0.1;  // [s]
const Footprint kRobot{0.18, 0.2};
constexpr double kGlass = 3.07;          // [m] x of the robot that touches the glass
constexpr double kBumperTravel = 0.005;  // [m] until it lets go

/// A room of 6 by 3 m, with a wall that leaves a gap of a metre at its top.
grid::OccupancyGrid room() {
  return test::drawnMap({"##############",  //
                         "#            #",  //
                         "#            #",  //
                         "#     #      #",  //
                         "#     #      #",  //
                         "#     #      #",  //
                         "#     #      #",  //
                         "##############"},
                        0.05, 10);
}

/// A robot that does what it is told, and whose laser sees a few points that the test puts there.
class Ride {
 public:
  explicit Ride(const NavigatorConfig& config = {}) : navigator(config, kRobot) {
    navigator.setMap(room());
  }

  NavigatorStep step() {
    now += kStep;
    if (sees) {
      Sighting sighting;
      sighting.stamp = now;
      for (const Eigen::Vector2d& p_map : points) {
        sighting.returns.emplace_back(pose.inverse() * p_map);
      }
      navigator.see(sighting, pose);
    }
    const auto known = is_lost ? std::nullopt : std::optional(geometry::StampedPose2{now, pose});
    NavigatorStep result = navigator.step(now, known, velocity);
    velocity = result.velocity;
    pose = pose * motion::Arc{velocity.linear * kStep, velocity.angular * kStep}.toMotion();
    if (has_glass && pose.x > kGlass) {
      pose.x = kGlass;
      contacts += is_pressed ? 0 : 1;
    }
    is_pressed = has_glass && pose.x > kGlass - kBumperTravel;
    if (is_pressed) {
      navigator.touch({pose.rotation().transpose() * Eigen::Vector2d(0.18, 0.0)}, now);
    }
    return result;
  }

  /// Until the goal is over, at most so long.
  NavigatorStep drive(double seconds) {
    NavigatorStep result;
    for (const double end = now + seconds; now < end;) {
      result = step();
      if (result.state == NavigationState::kReached || result.state == NavigationState::kFailed) {
        break;
      }
      least_room = std::min(least_room, navigator.costmap().solidClearance(pose.translation()));
    }
    return result;
  }

  Navigator navigator;
  geometry::Pose2 pose{1.5, 1.0, 3.0};
  motion::Twist2 velocity;
  std::vector<Eigen::Vector2d> points;
  double now{100.0};
  double least_room{1e9};
  bool sees{true};
  bool is_lost{false};
  bool has_glass{false};  ///< in the gap, where its laser doesn't see it
  bool is_pressed{false};
  int contacts{0};
};

TEST(Navigator, DrivesRoundTheWallAndTakesTheHeading) {
  Ride ride;
  ride.navigator.setGoal({{5.0, 1.0}, 1.0}, ride.now);
  const NavigatorStep last = ride.drive(60.0);
  EXPECT_EQ(last.state, NavigationState::kReached) << last.reason;
  EXPECT_LT((ride.pose.translation() - Eigen::Vector2d(5.0, 1.0)).norm(), 0.15);
  EXPECT_NEAR(ride.pose.theta, 1.0, 0.2);
  EXPECT_GE(ride.least_room, 0.19);
  EXPECT_LT(ride.now, 130.0);
  EXPECT_FALSE(ride.navigator.hasGoal());
}

TEST(Navigator, KeepsItsLimits) {
  Ride ride;
  ride.navigator.setGoal({{5.0, 1.0}, std::nullopt}, ride.now);
  const FollowerConfig limits;
  for (int i = 0; i < 300 && ride.navigator.hasGoal(); ++i) {
    const motion::Twist2 before = ride.velocity;
    (void)ride.step();
    if (!ride.navigator.hasGoal()) {
      break;
    }
    EXPECT_LE(std::abs(ride.velocity.linear), limits.max_linear_speed + 1e-9);
    EXPECT_LE(std::abs(ride.velocity.angular), limits.max_angular_speed + 1e-9);
    EXPECT_LE(std::abs(ride.velocity.linear - before.linear),
              limits.max_linear_acceleration * kStep + 1e-9);
    EXPECT_LE(std::abs(ride.velocity.angular - before.angular),
              limits.max_angular_acceleration * kStep + 1e-9);
  }
}

TEST(Navigator, RefusesAGoalThatTheMapHasNoWayTo) {
  Ride ride;
  ride.navigator.setGoal({{3.2, 1.0}, std::nullopt}, ride.now);
  const NavigatorStep last = ride.drive(1.0);
  EXPECT_EQ(last.state, NavigationState::kFailed);
  EXPECT_THAT(last.reason, testing::HasSubstr("in an obstacle"));
}

TEST(Navigator, WaitsForWhoStandsInTheWayAndGivesUpWithAReason) {
  Ride ride;
  for (double y = 2.0; y < 3.5; y += 0.04) {
    ride.points.emplace_back(3.25, y);  // all over the gap
  }
  ride.navigator.setGoal({{5.0, 1.0}, std::nullopt}, ride.now);
  EXPECT_EQ(ride.drive(2.0).state, NavigationState::kRecovering);
  const NavigatorStep last = ride.drive(120.0);
  EXPECT_EQ(last.state, NavigationState::kFailed);
  EXPECT_THAT(last.reason, testing::HasSubstr("no way"));
  EXPECT_GE(ride.least_room, 0.19);
}

TEST(Navigator, GoesOnWhenTheWayIsFreeAgain) {
  Ride ride;
  for (double y = 2.0; y < 3.5; y += 0.04) {
    ride.points.emplace_back(3.25, y);
  }
  ride.navigator.setGoal({{5.0, 1.0}, std::nullopt}, ride.now);
  (void)ride.drive(2.0);
  ride.points = {{6.4, 0.6}};  // they have gone; nothing clears their place but time
  EXPECT_EQ(ride.drive(90.0).state, NavigationState::kReached);
}

TEST(Navigator, StandsWhileItDoesNotKnowWhereItIsAndThenGoesOn) {
  Ride ride;
  ride.navigator.setGoal({{5.0, 1.0}, std::nullopt}, ride.now);
  (void)ride.drive(5.0);
  ride.is_lost = true;
  for (int i = 0; i < 10; ++i) {
    const NavigatorStep step = ride.step();
    EXPECT_EQ(step.state, NavigationState::kWaiting);
    EXPECT_EQ(step.velocity.linear, 0.0);
    EXPECT_EQ(step.velocity.angular, 0.0);
  }
  ride.is_lost = false;
  EXPECT_EQ(ride.drive(60.0).state, NavigationState::kReached);
}

TEST(Navigator, GivesUpWithoutScans) {
  Ride ride;
  ride.sees = false;
  ride.navigator.setGoal({{5.0, 1.0}, std::nullopt}, ride.now);
  EXPECT_EQ(ride.step().state, NavigationState::kWaiting);
  const NavigatorStep last = ride.drive(20.0);
  EXPECT_EQ(last.state, NavigationState::kFailed);
  EXPECT_EQ(last.reason, "There is no scan.");
  EXPECT_NEAR(ride.now, 110.1, 0.3);
}

TEST(Navigator, BacksOffFromAContactAndDrivesAroundIt) {
  Ride ride;
  ride.pose.theta = 1.5;
  ride.navigator.setGoal({{1.5, 3.0}, std::nullopt}, ride.now);
  (void)ride.drive(1.5);
  ride.navigator.touch({{0.18, 0.0}}, ride.now);
  const NavigatorStep after = ride.step();
  EXPECT_EQ(after.recovery, RecoveryStage::kBackOff);
  EXPECT_LT(after.velocity.linear, 0.0);
  EXPECT_EQ(ride.drive(60.0).state, NavigationState::kReached);
}

TEST(Navigator, TriesAPaneOfGlassTwiceAtMostAndThenKnowsThatThereIsNoWay) {
  Ride ride;
  ride.has_glass = true;
  ride.navigator.setGoal({{5.0, 1.0}, std::nullopt}, ride.now);
  const NavigatorStep last = ride.drive(120.0);
  EXPECT_EQ(last.state, NavigationState::kFailed);
  EXPECT_THAT(last.reason, testing::HasSubstr("no way"));
  EXPECT_GE(ride.contacts, 1);
  EXPECT_LE(ride.contacts, 2);
  ride.navigator.setGoal({{5.0, 2.0}, std::nullopt}, ride.now);
  EXPECT_EQ(ride.drive(1.0).state, NavigationState::kFailed);
}

TEST(Navigator, TouchesAPaneInAWallOnceHoweverWideItIs) {
  Ride ride;
  ride.navigator.setMap(test::drawnMap({"##############",  //
                                        "#     #      #",  //
                                        "#            #",  //
                                        "#            #",  //
                                        "#            #",  //
                                        "#            #",  //
                                        "#     #      #",  //
                                        "##############"},
                                       0.05, 10));
  ride.has_glass = true;
  ride.navigator.setGoal({{5.0, 1.0}, std::nullopt}, ride.now);
  const NavigatorStep last = ride.drive(120.0);
  EXPECT_EQ(last.state, NavigationState::kFailed);
  EXPECT_THAT(last.reason, testing::HasSubstr("no way"));
  EXPECT_EQ(ride.contacts, 1);
}

TEST(Navigator, LeavesAPaneSidewaysIfSomethingStandsBehindIt) {
  Ride ride;
  ride.has_glass = true;
  ride.pose = {kGlass, 2.9, 0.0};
  ride.points = {{2.82, 2.77}};
  ride.navigator.setGoal({{1.5, 1.0}, std::nullopt}, ride.now);
  const NavigatorStep last = ride.drive(60.0);
  EXPECT_EQ(last.state, NavigationState::kReached) << last.reason;
}

TEST(Navigator, WhatWasTouchedMovesWithTheCorrectedMap) {
  Ride ride;
  ride.pose = {3.2, 3.0, 0.0};
  (void)ride.step();
  ride.navigator.touch({{0.18, 0.0}, {0.0, 0.18}, {0.0, -0.18}}, ride.now);  // all over the gap
  const auto way = [&] { return ride.navigator.plan({1.5, 1.0}, {5.0, 1.0}); };
  ASSERT_FALSE(way().found());
  ride.navigator.moveMap({{{1.0, 1.0, 0.0}}, {{1.0, 1.0, 0.0}}});
  EXPECT_FALSE(way().found());
  // The keyframe beside the gap lies a metre farther down, in the wall; another one stays.
  ride.navigator.moveMap({{{3.0, 3.0, 0.0}, {1.0, 1.0, 0.0}}, {{3.0, 2.0, 0.0}, {1.0, 1.0, 0.0}}});
  EXPECT_TRUE(way().found()) << way().reason;
}

TEST(Contacts, MoveWithAMapThatMovesByLessThanACell) {
  Contacts contacts(0.05);
  contacts.add({{1.01, 0.0}}, 100.0);
  for (int i = 0; i < 20; ++i) {
    contacts.move({{{0.01 * i, 0.0, 0.0}}, {{0.01 * (i + 1), 0.0, 0.0}}});
  }
  EXPECT_FALSE(contacts.field().isClear({1.21, 0.0}, 0.05));
  EXPECT_TRUE(contacts.field().isClear({1.01, 0.0}, 0.1));
  contacts.add({{1.21, 0.0}}, 200.0);  // the same cell: it lasts longer
  contacts.expire(150.0);
  EXPECT_FALSE(contacts.field().isClear({1.21, 0.0}, 0.05));
  contacts.move({{{0.0, 0.0, 0.0}}, {{1e300, 0.0, 0.0}}});  // nonsense moves nothing
  EXPECT_FALSE(contacts.field().isClear({1.21, 0.0}, 0.05));
}

/// A corridor that goes round a block, 3 m wide and 12 m long.
grid::OccupancyGrid ring() {
  return test::drawnMap({"############################",  //
                         "#                          #",  //
                         "#                          #",  //
                         "#  ######################  #",  //
                         "#  ######################  #",  //
                         "#  ######################  #",  //
                         "#                          #",  //
                         "#                          #",  //
                         "############################"},
                        0.05, 10);
}

TEST(Navigator, DrivesTheWholeDetourAlthoughItForgetsWhatItIsFor) {
  Ride ride;
  ride.navigator.setMap(ring());
  ride.pose = {4.0, 1.0, 0.0};
  ride.navigator.setGoal({{9.0, 1.0}, std::nullopt}, ride.now);
  NavigatorStep last;
  for (int i = 0; i < 2000 && ride.navigator.hasGoal(); ++i) {
    ride.points.clear();
    const bool is_near = (ride.pose.translation() - Eigen::Vector2d(7.0, 1.0)).norm() < 2.0;
    for (double y = 0.6; y < 1.5 && is_near; y += 0.04) {
      ride.points.emplace_back(7.0, y);
    }
    last = ride.step();
  }
  EXPECT_EQ(last.state, NavigationState::kReached) << last.reason;
  EXPECT_LT(ride.now, 100.0 + 120.0);
}

TEST(Navigator, SurvivesTimeThatGoesBackwards) {
  Ride ride;
  ride.navigator.setGoal({{5.0, 1.0}, std::nullopt}, ride.now);
  (void)ride.drive(3.0);
  ride.now = 5.0;
  EXPECT_EQ(ride.drive(60.0).state, NavigationState::kReached);
}

TEST(Navigator, SameInputSameOutput) {
  Ride one;
  Ride other;
  for (Ride* ride : {&one, &other}) {
    ride->navigator.setGoal({{5.0, 1.0}, 0.0}, ride->now);
    (void)ride->drive(60.0);
  }
  EXPECT_EQ(one.pose.vector(), other.pose.vector());
  EXPECT_EQ(one.now, other.now);
}

}  // namespace
}  // namespace omega_slam::navigation

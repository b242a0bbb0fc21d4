#include "omega_slam/navigation/costmap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "omega_slam/motion/arc.h"
#include "omega_slam/navigation/follower.h"

namespace omega_slam::navigation {
namespace {

/// A room of 3 by 2 m with a post of one cell, the lower left corner of which is at (1.5, 1.0).
grid::OccupancyGrid roomWithPost() {
  grid::OccupancyGrid map = grid::makeGrid({0.05, {0.0, 0.0}, 60, 40}, grid::kFree);
  map.at({30, 20}) = grid::kOccupied;
  return map;
}

/// What is seen of the post, which truly stands so much [m] farther down.
Sighting postSeenFrom(const Eigen::Vector2d& robot, double lower) {
  Sighting sighting;
  sighting.stamp = 100.0;
  sighting.origin = robot;
  for (double x = 1.5; x <= 1.55; x += 0.01) {
    sighting.returns.emplace_back(x, 1.0 - lower);
  }
  return sighting;
}

TEST(Costmap, DrivingKeepsOffWhereAWallIsSeenPlansOffWhereItIsDrawn) {
  Costmap costmap({});
  costmap.setMap(roomWithPost());
  const Eigen::Vector2d robot(1.52, 0.7);
  costmap.see(postSeenFrom(robot, 0.04), robot);
  EXPECT_NEAR(costmap.solidClearance(robot), 0.26, 0.025);
  EXPECT_TRUE(costmap.isFree(robot, 0.29));
  costmap.forgetSeen();
  EXPECT_NEAR(costmap.solidClearance(robot), 0.30, 0.005);
}

TEST(Costmap, AWallIsRememberedForAMomentThoughItIsTooNearToBeSeen) {
  Costmap costmap({});
  costmap.setMap(roomWithPost());
  const Eigen::Vector2d robot(1.52, 0.7);
  Sighting sighting = postSeenFrom(robot, 0.04);
  costmap.see(sighting, robot);
  sighting.returns.clear();
  sighting.stamp += 1.5;
  costmap.see(sighting, robot);
  EXPECT_LT(costmap.solidClearance(robot), 0.285);
  sighting.stamp += 1.0;
  costmap.see(sighting, robot);
  EXPECT_NEAR(costmap.solidClearance(robot), 0.30, 0.005);
}

TEST(Costmap, BeamsAFewMillimetresShortMakeNoDoorNarrower) {
  Costmap costmap({});
  costmap.setMap(roomWithPost());
  const Eigen::Vector2d robot(1.52, 0.7);
  costmap.see(postSeenFrom(robot, 0.015), robot);
  EXPECT_NEAR(costmap.solidClearance(robot), 0.30, 0.005);
}

constexpr double kBase = 0.18;  // [m] of what may not be touched, with sensors 0.2 m

/// What the robot has come to on its way along a path past the post, and the least distance [m]
/// from its middle to the post, which stands lower than the map shows it, as it sees.
struct Pass {
  FollowState state{FollowState::kDriving};
  double least{1.0};
};

Pass passThePost(const grid::OccupancyGrid& map, double lower) {
  constexpr double kDt = 0.1;
  Costmap costmap({});
  costmap.setMap(map);
  Follower follower({}, {kBase, 0.2});
  follower.follow({{0.8, 0.79}, {2.2, 0.79}}, std::nullopt);
  geometry::Pose2 pose{0.8, 0.79, 0.0};
  motion::Twist2 velocity;
  Pass pass;
  for (int i = 0; i < 200 && pass.state != FollowState::kArrived; ++i) {
    costmap.see(postSeenFrom(pose.translation(), lower), pose.translation());
    const FollowerStep step = follower.step(costmap, pose, velocity, kDt);
    pass.state = step.state;
    velocity = step.velocity;
    pose = pose * motion::Arc{velocity.linear * kDt, velocity.angular * kDt}.toMotion();
    const Eigen::Vector2d nearest(std::clamp(pose.x, 1.5, 1.55), 1.0 - lower);
    pass.least = std::min(pass.least, (nearest - pose.translation()).norm());
  }
  return pass;
}

TEST(Costmap, ARobotDoesNotTouchWhatItSeesBesideAPathThatItsMapShowsFree) {
  const Pass pass = passThePost(roomWithPost(), 0.045);
  EXPECT_GE(pass.least, kBase);
  EXPECT_EQ(pass.state, FollowState::kArrived);
}

TEST(Costmap, ARobotThatItsMapShowsTooNearToAWallDoesNotTouchWhatItSeesElsewhere) {
  grid::OccupancyGrid map = roomWithPost();
  for (int col = 0; col < 60; ++col) {
    map.at({col, 12}) = grid::kOccupied;  // up to 0.65 m: it stands 0.14 m from it, and may go on
  }
  EXPECT_GE(passThePost(map, 0.045).least, kBase);
}

}  // namespace
}  // namespace omega_slam::navigation

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "omega_slam/simulation/turtlebot.h"
#include "support/drawn_world.h"
#include "support/seeds.h"

namespace omega_slam::simulation {
namespace {

/// Obstacles of all materials, gaps narrower and wider than the robot.
std::shared_ptr<const World> obstacleCourse() {
  return test::drawnWorld({"####################",  //
                           "#........#.........#",  //
                           "#........#....d....#",  //
                           "#...g..............#",  //
                           "#........#.........#",  //
                           "#..#.....#....##...#",  //
                           "#........#.....#...#",  //
                           "#.............g....#",  //
                           "####################"},
                          0.3);
}

TEST(TurtleBotProperty, HoweverItIsDrivenItNeverEntersAnObstacle) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> linear(-0.9, 0.9);
    std::uniform_real_distribution<double> angular(-3.5, 3.5);
    const auto world = obstacleCourse();
    TurtleBotConfig config;
    config.seed = seed;
    TurtleBot robot(world, {0.8, 0.6, 0.0}, config);
    Twist2 command;
    for (int i = 0; i < 20000; ++i) {
      if (i % 40 == 0) {
        command = {linear(random), angular(random)};
      }
      ASSERT_TRUE(robot.command(command));
      const TurtleBotEvents events = robot.step();
      const Eigen::Vector2d position = events.truth.T_world_base.translation();
      ASSERT_FALSE(world->nearestObstacle(position, config.kobuki.radius - 1e-6))
          << "step " << i << " at (" << position.x() << ", " << position.y() << ")";
      ASSERT_TRUE(events.odometry.T_odom_base.isFinite());
    }
    EXPECT_GT(robot.collisions(), 10);
  }
}

TEST(TurtleBotProperty, BumperIsPressedOnlyWhereSomethingIsNear) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> angular(-1.5, 1.5);
    const auto world = obstacleCourse();
    TurtleBotConfig config;
    TurtleBot robot(world, {0.8, 0.6, 0.0}, config);
    int pressed = 0;
    for (int i = 0; i < 10000; ++i) {
      ASSERT_TRUE(robot.command({0.3, i % 100 == 0 ? angular(random) : 0.3}));
      robot.step();
      if (robot.bumper().any()) {
        ++pressed;
        EXPECT_TRUE(world->nearestObstacle(robot.truth().T_world_base.translation(),
                                           config.kobuki.radius + 0.006));
      }
    }
    EXPECT_GT(pressed, 0);
  }
}

}  // namespace
}  // namespace omega_slam::simulation

#include "omega_slam/simulation/turtlebot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

#include "support/drawn_world.h"

namespace omega_slam::simulation {
namespace {

/// All that a drive says, byte by byte.
std::string recordDrive(std::uint64_t seed) {
  TurtleBotConfig config;
  config.seed = seed;
  TurtleBot robot(test::emptyRoom(2.0), {}, config);
  std::string bytes;
  const auto append = [&bytes](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  for (int i = 0; i < 300; ++i) {
    EXPECT_TRUE(robot.command({0.5 * std::sin(0.02 * i), 0.8}));
    const TurtleBotEvents events = robot.step();
    append(events.odometry.T_odom_base);
    append(events.odometry.left);
    append(events.truth.T_world_base);
    if (events.scan) {
      append(events.scan->stamp);
      for (const float range : events.scan->ranges) {
        append(range);
      }
    }
  }
  return bytes;
}

TEST(TurtleBot, SameSeedSameBytes) {
  EXPECT_EQ(recordDrive(7), recordDrive(7));
  EXPECT_NE(recordDrive(7), recordDrive(8));
}

TEST(TurtleBot, HasOdometryBeforeItsFirstScanBegins) {
  TurtleBot robot(test::emptyRoom(1.0), {}, {});
  const double first_odometry = robot.now().odometry.stamp;
  EXPECT_EQ(robot.now().truth.stamp, first_odometry);
  TurtleBotEvents events;
  while (!events.scan) {
    events = robot.step();
  }
  EXPECT_LE(first_odometry, events.scan->stamp);
}

TEST(TurtleBot, TimeIsCountedAndDoesNotDrift) {
  TurtleBot robot(test::emptyRoom(1.0), {}, {});
  EXPECT_EQ(robot.time(), 1.0);
  for (int i = 0; i < 50000; ++i) {
    robot.step();
  }
  EXPECT_NEAR(robot.time(), 1001.0, 1e-9);
}

TEST(TurtleBot, BringsOdometryEachStepAndTenScansASecond) {
  TurtleBot robot(test::emptyRoom(1.0), {}, {});
  int scans = 0;
  double last_stamp = 0.0;
  for (int i = 1; i <= 500; ++i) {
    const TurtleBotEvents events = robot.step();
    EXPECT_NEAR(events.odometry.stamp, 1.0 + 0.02 * i, 1e-9);
    if (events.scan) {
      ++scans;
      EXPECT_GT(events.scan->stamp, last_stamp);
      EXPECT_LT(events.scan->stamp, events.odometry.stamp);
      last_stamp = events.scan->stamp;
    }
  }
  EXPECT_EQ(scans, 100);
}

TEST(TurtleBot, SeesFromWhereItsLaserIs) {
  TurtleBotConfig config;
  config.hokuyo.near_accuracy = config.hokuyo.far_accuracy = 0.0;
  config.T_base_laser = {0.10, 0.0, 0.0};
  TurtleBot robot(test::emptyRoom(1.0), {}, config);
  for (int i = 0; i < 10; ++i) {
    if (const auto scan = robot.step().scan) {
      EXPECT_NEAR(scan->ranges[341], 0.9, 1e-6);
      return;
    }
  }
  FAIL() << "no scan came";
}

TEST(TurtleBot, OdometryIsTheTruthWithoutNoise) {
  TurtleBotConfig config;
  config.odometry.noise = {0.0, 0.0, 0.0, 0.0};
  const geometry::Pose2 start{0.3, -0.2, 0.7};
  TurtleBot robot(test::emptyRoom(3.0), start, config);
  for (int i = 0; i < 200; ++i) {
    EXPECT_TRUE(robot.command({0.3, 0.4}));
    const TurtleBotEvents events = robot.step();
    const geometry::Pose2 error = geometry::relativePose(
        geometry::relativePose(start, events.truth.T_world_base), events.odometry.T_odom_base);
    EXPECT_LT(error.vector().norm(), 1e-9);
  }
}

TEST(TurtleBot, ReportsTheBumperWhenItChanges) {
  TurtleBot robot(test::emptyRoom(1.0), {0.5, 0.0, 0.0}, {});
  std::vector<Bumper> changes;
  for (int i = 0; i < 200; ++i) {
    EXPECT_TRUE(robot.command({i < 100 ? 0.4 : -0.4, 0.0}));
    if (const auto bumper = robot.step().bumper) {
      changes.push_back(*bumper);
    }
  }
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_TRUE(changes[0].centre);
  EXPECT_FALSE(changes[1].any());
  EXPECT_EQ(robot.collisions(), 1);
}

TEST(TurtleBot, CarriedBackItStandsAtItsStartAndOdometryKnowsNothing) {
  const geometry::Pose2 start{0.5, 0.2, 1.0};
  TurtleBot robot(test::emptyRoom(3.0), start, {});
  geometry::Pose2 odometry;
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(robot.command({0.4, 0.3}));
    odometry = robot.step().odometry.T_odom_base;
  }
  robot.resetPosition();
  const TurtleBotEvents events = robot.step();
  EXPECT_EQ(events.truth.T_world_base.vector(), start.vector());
  EXPECT_EQ(events.odometry.T_odom_base.vector(), odometry.vector());
  EXPECT_NEAR(events.truth.stamp, 1.0 + 101 * 0.02, 1e-9);
}

TEST(TurtleBot, OdometryCanBeSetToZero) {
  TurtleBot robot(test::emptyRoom(3.0), {}, {});
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(robot.command({0.4, 0.0}));
    robot.step();
  }
  const geometry::Pose2 truth = robot.truth().T_world_base;
  robot.resetOdometry();
  EXPECT_LT(robot.step().odometry.T_odom_base.vector().norm(), 0.01);
  EXPECT_GT(robot.truth().T_world_base.x, truth.x);
}

TEST(TurtleBot, ANoisierOdometryLeavesTheLaserAlone) {
  TurtleBotConfig noisy;
  noisy.odometry.noise.rotation_per_rotation = 0.5;
  TurtleBot one(test::emptyRoom(2.0), {}, {});
  TurtleBot other(test::emptyRoom(2.0), {}, noisy);
  for (int i = 0; i < 50; ++i) {
    EXPECT_TRUE(one.command({0.1, 0.4}));
    EXPECT_TRUE(other.command({0.1, 0.4}));
    const auto a = one.step().scan;
    const auto b = other.step().scan;
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) {
      EXPECT_EQ(a->ranges, b->ranges);
    }
  }
}

TEST(TurtleBot, RefusesToStartInAWall) {
  const auto room = test::emptyRoom(1.0);
  EXPECT_THROW(TurtleBot(room, {0.95, 0.0, 0.0}, {}), std::invalid_argument);
  EXPECT_THROW(TurtleBot(room, {50.0, 0.0, 0.0}, {}), std::invalid_argument);
  EXPECT_THROW(TurtleBot(room, {std::nan(""), 0.0, 0.0}, {}), std::invalid_argument);
}

TEST(TurtleBotConfiguration, NamesEveryViolationWithItsGroup) {
  TurtleBotConfig config;
  EXPECT_TRUE(config.validate().empty());
  config.time_step = 0.5;
  config.start_time = 0.0;
  config.kobuki.radius = -1.0;
  config.odometry.segment = 0.0;
  config.hokuyo.beams = -1;
  EXPECT_THAT(config.validate(), ::testing::ElementsAre(::testing::HasSubstr("start_time"),
                                                        ::testing::HasSubstr("hokuyo/rate"),
                                                        ::testing::HasSubstr("kobuki/radius"),
                                                        ::testing::HasSubstr("odometry/segment"),
                                                        ::testing::HasSubstr("hokuyo/beams")));
}

}  // namespace
}  // namespace omega_slam::simulation

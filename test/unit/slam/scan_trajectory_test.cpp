#include "omega_slam/slam/scan_trajectory.h"

#include <gtest/gtest.h>

#include <vector>

namespace omega_slam::slam {
namespace {

using geometry::Pose2;

/// Odometry that drives along x at 1 m/s from 0 s to `seconds`.
motion::OdometryBuffer straightOdometry(int seconds) {
  motion::OdometryBuffer odometry(1e9);
  for (int second = 0; second <= seconds; ++second) {
    odometry.add(second, Pose2{static_cast<double>(second), 0.0, 0.0});
  }
  return odometry;
}

void expectPose(const Pose2& pose, double x, double y, double theta) {
  EXPECT_NEAR(pose.x, x, 1e-9);
  EXPECT_NEAR(pose.y, y, 1e-9);
  EXPECT_NEAR(pose.theta, theta, 1e-9);
}

TEST(ScanTrajectoryTest, ThereIsNoneWithoutKeyframes) {
  EXPECT_TRUE(scanTrajectory({1.0, 2.0}, straightOdometry(3), {}).empty());
}

TEST(ScanTrajectoryTest, AKeyframeHasItsSolvedPose) {
  const std::vector<KeyframePlacement> keyframes{{1.0, {1.0, 0.0, 0.0}, {5.0, 6.0, 0.7}},
                                                 {3.0, {3.0, 0.0, 0.0}, {-1.0, 2.0, -0.4}}};
  const auto trajectory = scanTrajectory({1.0, 3.0}, straightOdometry(4), keyframes);
  ASSERT_EQ(trajectory.size(), 2U);
  EXPECT_EQ(trajectory[0].stamp, 1.0);
  expectPose(trajectory[0].pose, 5.0, 6.0, 0.7);
  expectPose(trajectory[1].pose, -1.0, 2.0, -0.4);
}

TEST(ScanTrajectoryTest, OutsideOfTheKeyframesTheOdometryGoesOnFromTheNearest) {
  const double quarter_turn = 1.5707963267948966;
  const std::vector<KeyframePlacement> keyframes{{1.0, {1.0, 0.0, 0.0}, {0.0, 0.0, quarter_turn}}};
  const auto trajectory = scanTrajectory({0.0, 4.0}, straightOdometry(4), keyframes);
  ASSERT_EQ(trajectory.size(), 2U);
  expectPose(trajectory[0].pose, 0.0, -1.0, quarter_turn);
  expectPose(trajectory[1].pose, 0.0, 3.0, quarter_turn);
}

TEST(ScanTrajectoryTest, BetweenKeyframesTheErrorOfTheOdometryIsSpreadOverTime) {
  // The graph says that 4 m of odometry were 4.4 m.
  const std::vector<KeyframePlacement> keyframes{{0.0, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}},
                                                 {4.0, {4.0, 0.0, 0.0}, {4.4, 0.0, 0.0}}};
  const auto trajectory = scanTrajectory({1.0, 2.0, 3.5}, straightOdometry(4), keyframes);
  ASSERT_EQ(trajectory.size(), 3U);
  expectPose(trajectory[0].pose, 1.1, 0.0, 0.0);
  expectPose(trajectory[1].pose, 2.2, 0.0, 0.0);
  expectPose(trajectory[2].pose, 3.85, 0.0, 0.0);
}

TEST(ScanTrajectoryTest, AScanThatTheOdometryDoesNotCoverGetsNoPose) {
  const std::vector<KeyframePlacement> keyframes{{1.0, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}};
  const auto trajectory = scanTrajectory({-1.0, 2.0, 9.0}, straightOdometry(4), keyframes);
  ASSERT_EQ(trajectory.size(), 1U);
  EXPECT_EQ(trajectory[0].stamp, 2.0);
}

}  // namespace
}  // namespace omega_slam::slam

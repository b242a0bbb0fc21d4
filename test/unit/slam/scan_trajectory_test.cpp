#include "omega_slam/slam/scan_trajectory.h"

#include <gtest/gtest.h>

#include <vector>

namespace omega_slam::slam {
namespace {

using geometry::Pose2;

void expectPose(const Pose2& pose, double x, double y, double theta) {
  EXPECT_NEAR(pose.x, x, 1e-9);
  EXPECT_NEAR(pose.y, y, 1e-9);
  EXPECT_NEAR(pose.theta, theta, 1e-9);
}

/// A robot that was tracked along x at 1 m/s: a keyframe at 0 s, one at 4 s, and on to 5 s.
std::vector<ScanTrack> straightTracks() {
  return {{0.0, 0, {}, true},
          {1.0, 0, {1.0, 0.0, 0.0}, false},
          {2.0, 0, {2.0, 0.0, 0.0}, false},
          {3.0, 0, {3.0, 0.0, 0.0}, false},
          {4.0, 0, {4.0, 0.0, 0.0}, true},
          {5.0, 1, {1.0, 0.0, 0.0}, false}};
}

TEST(ScanTrajectoryTest, ThereIsNoneWithoutKeyframes) {
  EXPECT_TRUE(scanTrajectory(straightTracks(), {}).empty());
  EXPECT_TRUE(scanTrajectory({}, {{}, {}}).empty());
}

TEST(ScanTrajectoryTest, AKeyframeHasItsSolvedPose) {
  const auto trajectory = scanTrajectory(straightTracks(), {{5.0, 6.0, 0.7}, {-1.0, 2.0, -0.4}});
  ASSERT_EQ(trajectory.size(), 6U);
  EXPECT_EQ(trajectory[4].stamp, 4.0);
  expectPose(trajectory[0].pose, 5.0, 6.0, 0.7);
  expectPose(trajectory[4].pose, -1.0, 2.0, -0.4);
}

TEST(ScanTrajectoryTest, BetweenKeyframesTheErrorIsSpreadOverTheScans) {
  // The graph says that 4 m of tracking were 4.4 m.
  const auto trajectory = scanTrajectory(straightTracks(), {{}, {4.4, 0.0, 0.0}});
  ASSERT_EQ(trajectory.size(), 6U);
  expectPose(trajectory[1].pose, 1.1, 0.0, 0.0);
  expectPose(trajectory[2].pose, 2.2, 0.0, 0.0);
  expectPose(trajectory[3].pose, 3.3, 0.0, 0.0);
}

TEST(ScanTrajectoryTest, AfterTheLastKeyframeItGoesOnFromThere) {
  const double quarter_turn = 1.5707963267948966;
  const auto trajectory = scanTrajectory(straightTracks(), {{}, {4.0, 0.0, quarter_turn}});
  ASSERT_EQ(trajectory.size(), 6U);
  expectPose(trajectory[5].pose, 4.0, 1.0, quarter_turn);
}

TEST(ScanTrajectoryTest, ScansOfAKeyframeThatTheGraphDoesNotKnowYetGetNoPose) {
  const auto trajectory = scanTrajectory(straightTracks(), {{}});
  ASSERT_EQ(trajectory.size(), 5U);
  expectPose(trajectory[4].pose, 4.0, 0.0, 0.0);  // of the keyframe before, carried on
}

TEST(ScanTrajectoryTest, MissingKeyframeScansAreBridged) {
  auto tracks = straightTracks();
  tracks.erase(tracks.begin() + 4);  // a message that was lost
  const auto trajectory = scanTrajectory(tracks, {{}, {4.0, 0.0, 0.0}});
  ASSERT_EQ(trajectory.size(), 5U);
  expectPose(trajectory[3].pose, 3.0, 0.0, 0.0);
  expectPose(trajectory[4].pose, 5.0, 0.0, 0.0);
}

}  // namespace
}  // namespace omega_slam::slam

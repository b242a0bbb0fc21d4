#include "nodes/common/run_recorder_end.h"

#include <gtest/gtest.h>

namespace omega_slam {
namespace {

using Phase = RunEnd::Phase;

/// A run in full swing: ten keyframes, all of them solved and drawn.
RunProgress driving() {
  RunProgress progress;
  progress.time = 60.0;
  progress.elapsed = 50.0;
  progress.wall_time = 1000.0;
  progress.route_status = "driving 3/7";
  progress.keyframes = 10;
  progress.graph_poses = 10;
  progress.graph_stamp = 59.0;
  progress.map_stamp = 59.0;
  return progress;
}

TEST(RunEndTest, ARunGoesOnWhileTheRobotDrives) {
  RunEnd end(RunEndConfig{});
  EXPECT_EQ(end.update(driving()), Phase::kRunning);
  EXPECT_TRUE(end.reason().empty());
}

TEST(RunEndTest, ADoneRouteEndsItOnceTheScansHaveSettled) {
  RunEnd end(RunEndConfig{});
  RunProgress progress = driving();
  progress.route_status = "done";
  EXPECT_EQ(end.update(progress), Phase::kSettling);
  progress.time += 0.9;
  EXPECT_EQ(end.update(progress), Phase::kSettling);
  progress.time += 0.2;
  EXPECT_EQ(end.update(progress), Phase::kOver);
  EXPECT_EQ(end.reason(), "route done");
  EXPECT_TRUE(end.settled());
}

TEST(RunEndTest, AStuckRobotEndsItAndTellsWhy) {
  RunEnd end(RunEndConfig{});
  RunProgress progress = driving();
  progress.route_status = "stuck: bumped 3 times on the way to waypoint 4";
  EXPECT_EQ(end.update(progress), Phase::kSettling);
  EXPECT_EQ(end.reason(), "robot stuck: bumped 3 times on the way to waypoint 4");
}

TEST(RunEndTest, DurationCountsFromTheFirstMessage) {
  RunEndConfig config;
  config.duration = 50.5;
  RunEnd end(config);
  RunProgress progress = driving();
  EXPECT_EQ(end.update(progress), Phase::kRunning);  // 60 s by the clock, but 50 s of the run
  progress.elapsed = 50.5;
  EXPECT_EQ(end.update(progress), Phase::kSettling);
  EXPECT_EQ(end.reason(), "time is up");
}

TEST(RunEndTest, ItWaitsForTheGraphToHoldEveryKeyframe) {
  RunEnd end(RunEndConfig{});
  RunProgress progress = driving();
  progress.route_status = "done";
  progress.keyframes = 11;
  end.update(progress);
  progress.time += 5.0;
  EXPECT_EQ(end.update(progress), Phase::kSettling);
  progress.graph_poses = 11;
  EXPECT_EQ(end.update(progress), Phase::kOver);
}

TEST(RunEndTest, ItWaitsForTheMapToShowTheGraph) {
  RunEnd end(RunEndConfig{});
  RunProgress progress = driving();
  progress.route_status = "done";
  progress.map_stamp = 57.0;
  end.update(progress);
  progress.time += 5.0;
  EXPECT_EQ(end.update(progress), Phase::kSettling);
  progress.map_stamp = 59.0;
  EXPECT_EQ(end.update(progress), Phase::kOver);
}

TEST(RunEndTest, KeyframesMadeWhileItWaitsAreNotWaitedFor) {
  RunEnd end(RunEndConfig{});
  RunProgress progress = driving();
  progress.route_status = "done";
  progress.map_stamp = 58.0;
  end.update(progress);
  progress.time += 1.5;
  EXPECT_EQ(end.update(progress), Phase::kSettling);
  progress.keyframes = 14;
  progress.graph_poses = 13;  // always a step behind the robot, as is the map behind the graph
  progress.graph_stamp = 61.0;
  progress.map_stamp = 59.5;
  EXPECT_EQ(end.update(progress), Phase::kOver);
  EXPECT_TRUE(end.settled());
}

TEST(RunEndTest, WhatNeverSettlesEndsAtTheDeadlineAndSaysSo) {
  RunEndConfig config;
  config.settle_deadline = 20.0;
  RunEnd end(config);
  RunProgress progress = driving();
  progress.route_status = "done";
  progress.map_stamp = 0.0;
  end.update(progress);
  progress.wall_time += 19.9;
  EXPECT_EQ(end.update(progress), Phase::kSettling);
  progress.wall_time += 0.2;
  EXPECT_EQ(end.update(progress), Phase::kOver);
  EXPECT_FALSE(end.settled());
}

TEST(RunEndTest, OnceOverItStaysOver) {
  RunEndConfig config;
  config.settle_time = 0.0;
  RunEnd end(config);
  RunProgress progress = driving();
  progress.route_status = "done";
  EXPECT_EQ(end.update(progress), Phase::kOver);
  EXPECT_EQ(end.update(driving()), Phase::kOver);
  EXPECT_EQ(end.reason(), "route done");
}

}  // namespace
}  // namespace omega_slam

#include "nodes/common/run_recorder_record.h"

#include <gtest/gtest.h>

#include <vector>

namespace omega_slam {
namespace {

using geometry::Pose2;

constexpr double kQuarterTurn = 1.5707963267948966;

/// Ten seconds at 1 m/s along the world's y axis, from (5, 7); odometry and tracking measure 2 %
/// too much, and the odometry begins at zero; keyframes at 1 s and 9 s, of which the graph knows
/// the truth.
RunRecord drive() {
  RunRecord record;
  for (int second = 0; second <= 10; ++second) {
    record.addTruth(second, Pose2{5.0, 7.0 + second, kQuarterTurn});
    record.addOdometry(second, Pose2{1.02 * second, 0.0, 0.0});
    record.addScan(second);
    const bool is_keyframe = second == 1 || second == 9;
    if (second >= 1) {  // the first keyframe is the first scan that is tracked
      const Pose2 tracked{1.02 * (second - (second <= 9 ? 1 : 9)), 0.0, 0.0};
      record.addTrack(7,
                      {static_cast<double>(second), second <= 9 ? 0U : 1U, tracked, is_keyframe});
    }
  }
  record.addKeyframe(0, 1.0);
  record.addKeyframe(1, 9.0);
  graph::PoseGraph graph;
  graph.poses = {Pose2{0.0, 0.0, 0.0}, Pose2{8.0, 0.0, 0.0}};
  record.setGraph(graph, {1.0, 9.0});
  return record;
}

TEST(RunRecordTest, AnEmptyRecordKnowsNothing) {
  const RunRecord record;
  EXPECT_TRUE(record.estimate().empty());
  EXPECT_TRUE(record.truth().empty());
  EXPECT_FALSE(record.worldFromMap());
  EXPECT_FALSE(record.poseError({1.0, Pose2{}}));
  EXPECT_EQ(record.keyframes(), 0U);
  EXPECT_EQ(record.elapsed(), 0.0);
}

TEST(RunRecordTest, TheMapBeginsWhereTheRobotTrulyWasAtTheFirstKeyframe) {
  const auto T_world_map = drive().worldFromMap();
  ASSERT_TRUE(T_world_map);
  EXPECT_NEAR(T_world_map->x, 5.0, 1e-9);
  EXPECT_NEAR(T_world_map->y, 8.0, 1e-9);
  EXPECT_NEAR(T_world_map->theta, kQuarterTurn, 1e-9);
}

TEST(RunRecordTest, WhereTheTruthComesLateALaterKeyframeTells) {
  RunRecord record;
  for (int second = 5; second <= 10; ++second) {
    record.addTruth(second, Pose2{5.0, 7.0 + second, kQuarterTurn});
  }
  record.setGraph(drive().graph(), drive().graphStamps());
  const auto T_world_map = record.worldFromMap();
  ASSERT_TRUE(T_world_map);
  EXPECT_NEAR(T_world_map->x, 5.0, 1e-9);
  EXPECT_NEAR(T_world_map->y, 8.0, 1e-9);
}

TEST(RunRecordTest, EveryTrackedScanGetsAPose) {
  const auto estimate = drive().estimate();
  ASSERT_EQ(estimate.size(), 10U);
  EXPECT_NEAR(estimate[0].pose.x, 0.0, 1e-9);
  EXPECT_NEAR(estimate[4].pose.x, 4.0, 1e-9);
  EXPECT_NEAR(estimate[8].pose.x, 8.0, 1e-9);
  EXPECT_NEAR(estimate[9].pose.x, 9.02, 1e-9);
}

TEST(RunRecordTest, ANewRunForgetsTheTracksOfTheOneBefore) {
  RunRecord record = drive();
  record.addTrack(8, {12.0, 0, {}, true});
  ASSERT_EQ(record.estimate().size(), 1U);
  EXPECT_EQ(record.estimate()[0].stamp, 12.0);
}

TEST(RunRecordTest, ThePoseErrorIsTheDistanceFromTheTruth) {
  const RunRecord record = drive();
  const auto none = record.poseError({5.0, Pose2{4.0, 0.0, 0.0}});
  const auto some = record.poseError({5.0, Pose2{4.3, 0.4, 1.0}});
  ASSERT_TRUE(none && some);
  EXPECT_NEAR(*none, 0.0, 1e-9);
  EXPECT_NEAR(*some, 0.5, 1e-9);
}

TEST(RunRecordTest, DistanceAndTimeAreThoseOfTheRun) {
  const RunRecord record = drive();
  EXPECT_NEAR(record.distance(), 10.0, 1e-9);
  EXPECT_EQ(record.elapsed(), 10.0);
  EXPECT_EQ(record.newest(), 10.0);
  EXPECT_EQ(record.scans(), 11U);
  EXPECT_EQ(record.keyframes(), 2U);
}

TEST(RunRecordTest, OnlyLoopsAreCountedAsLoops) {
  RunRecord record = drive();
  graph::PoseGraph graph = record.graph();
  graph.constraints.resize(4);
  graph.constraints[1].kind = graph::ConstraintKind::kMatch;
  graph.constraints[2].kind = graph::ConstraintKind::kLoop;
  record.setGraph(graph, {1.0, 9.0});
  EXPECT_EQ(record.loops(), 1U);
}

TEST(RunRecordTest, ClearedItIsAsNew) {
  RunRecord record = drive();
  record.clear();
  EXPECT_TRUE(record.estimate().empty());
  EXPECT_EQ(record.distance(), 0.0);
  EXPECT_EQ(record.scans(), 0U);
}

}  // namespace
}  // namespace omega_slam

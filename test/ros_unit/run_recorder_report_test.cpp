#include "nodes/common/run_recorder_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace omega_slam {
namespace {

using geometry::Pose2;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Ten seconds at 1 m/s along the x axis of the world, SLAM 0.1 m to the left from halfway on.
RunRecord drive() {
  RunRecord record;
  graph::PoseGraph graph;
  std::vector<double> stamps;
  for (int second = 0; second <= 10; ++second) {
    const double x = second;
    record.addTruth(second, Pose2{1.0 + x, 1.0, 0.0});
    record.addOdometry(second, Pose2{x, 0.02 * x * x, 0.04 * x});
    record.addScan(second);
    const auto before = static_cast<graph::NodeId>(std::max(second, 1) - 1);
    record.addTrack(1, {x, before, Pose2{second > 0 ? 1.0 : 0.0, 0.0, 0.0}, true});
    record.addKeyframe(static_cast<graph::NodeId>(second), second);
    graph.poses.push_back(Pose2{x, second < 5 ? 0.0 : 0.1, 0.0});
    stamps.push_back(second);
  }
  record.setGraph(graph, stamps);
  return record;
}

/// A corridor of 13 x 2 m between walls, as the truth and, seen from (1, 1), as the map.
grid::OccupancyGrid corridor(const Eigen::Vector2d& origin) {
  grid::GridGeometry geometry;
  geometry.resolution = 0.5;
  geometry.origin = origin;
  geometry.width = 26;
  geometry.height = 6;
  grid::OccupancyGrid map = grid::makeGrid(geometry, grid::kFree);
  for (int column = 0; column < geometry.width; ++column) {
    map.at({column, 0}) = grid::kOccupied;
    map.at({column, 5}) = grid::kOccupied;
  }
  return map;
}

RunEnding done() { return {"route done", true, 3.0}; }

TEST(RunReportTest, ItComparesTrajectoryAndMapWithTheTruth) {
  RunRecord record = drive();
  record.setMap(corridor({-1.0, -1.5}), 10.0);
  const TrueWorld world{"corridor", corridor({0.0, -0.5}), {1.0, 1.0}};
  const auto report = makeReport(record, done(), {}, world);
  ASSERT_TRUE(report.trajectory_error);
  EXPECT_GT(report.trajectory_error->translation.max, 0.01);
  EXPECT_LT(report.trajectory_error->translation.max, 0.1);
  ASSERT_TRUE(report.resemblance);
  EXPECT_EQ(report.resemblance->score(), 1.0);
  EXPECT_EQ(report.keyframes, 11U);
  EXPECT_THAT(report.input, HasSubstr("corridor"));
  EXPECT_THAT(report.notes, Contains(HasSubstr("odometry alone")));
}

TEST(RunReportTest, WithoutTruthItMakesNoClaims) {
  const auto report = makeReport(RunRecord(), done(), {}, std::nullopt);
  EXPECT_FALSE(report.trajectory_error);
  EXPECT_FALSE(report.resemblance);
  EXPECT_FALSE(report.map);
  EXPECT_THAT(report.notes, Contains(HasSubstr("no map")));
}

TEST(RunReportTest, ItSaysWhereTheMapHadNotCaughtUp) {
  const RunEnding hasty{"interrupted", false, 1.0};
  EXPECT_THAT(makeReport(drive(), hasty, {}, std::nullopt).notes,
              Contains(HasSubstr("before it had caught up")));
  EXPECT_THAT(makeReport(drive(), done(), {}, std::nullopt).notes,
              Not(Contains(HasSubstr("before it had caught up"))));
}

TEST(RunReportTest, RejectedScansAndRefusedInputsAreTold) {
  diagnostic_msgs::DiagnosticArray message;
  message.status.resize(2);
  message.status[0].name = "scan_matcher: faults";
  message.status[0].values.resize(1);
  message.status[0].values[0].key = "rejected: no odometry";
  message.status[0].values[0].value = "4";
  message.status[1] = message.status[0];
  message.status[1].name = "map_builder: faults";
  RunAccounts accounts;
  accounts.update(message);
  const auto report = makeReport(drive(), done(), accounts, std::nullopt);
  ASSERT_TRUE(report.scans);
  EXPECT_EQ(report.scans->rejections.at("no odometry"), 4U);
  EXPECT_THAT(report.notes, Contains("map_builder refused 4 of its inputs."));
  EXPECT_THAT(formatClosing(report, done()), HasSubstr("4 rejected"));
}

TEST(RunReportTest, LoopsHaveTheirWeightsAndTheWithdrawnOnesNone) {
  RunRecord record = drive();
  graph::PoseGraph graph = record.graph();
  graph::Constraint loop;
  loop.to = 4;
  loop.kind = graph::ConstraintKind::kLoop;
  graph.constraints = {loop};
  record.setGraph(graph, record.graphStamps(), {{0.25}, {loop, loop}, {loop}});
  const auto report = makeReport(record, done(), {}, std::nullopt);
  ASSERT_EQ(report.loops->size(), 4U);
  EXPECT_EQ(report.loops->at(0).weight, 0.25);
  EXPECT_EQ(report.loops->at(1).weight, 0.0);
  EXPECT_EQ(report.loops->at(2).residual_translation, 4.0);
  EXPECT_TRUE(report.loops->at(3).is_folded);
  EXPECT_THAT(report.notes, Contains(HasSubstr("2 loops were withdrawn")));
  EXPECT_THAT(formatClosing(report, done()), HasSubstr("2 loops"));
}

TEST(RunReportTest, TheClosingLinesHoldTheMainFigures) {
  const auto report = makeReport(drive(), done(), {}, std::nullopt);
  const std::string closing = formatClosing(report, done());
  EXPECT_THAT(closing, HasSubstr("Route done: 10 s simulated in 3 s, 10.0 m driven, 11 keyframes"));
  EXPECT_THAT(closing, HasSubstr("Trajectory: 0.0"));
  EXPECT_THAT(closing, Not(HasSubstr("Map: ")));
}

}  // namespace
}  // namespace omega_slam

#include "omega_slam/graph/solver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/graphs.h"

namespace omega_slam::graph {
namespace {

Constraint tie(NodeId from, NodeId to) { return test::tie(from, to, {1.0, 0.0, 0.0}); }

TEST(SolverHostile, EmptyGraphAndSingleNode) {
  PoseGraph graph;
  EXPECT_EQ(solve(graph).status, SolveStatus::kConverged);
  graph.poses.resize(1);
  EXPECT_EQ(solve(graph).status, SolveStatus::kConverged);
}

TEST(SolverHostile, UnconnectedPartsAreHeldEachByItselfAndItIsSaid) {
  PoseGraph graph;
  graph.poses = {{}, {0.5, 0.0, 0.0}, {7.0, 7.0, 0.0}, {8.5, 7.0, 0.0}};
  graph.constraints = {tie(0, 1), tie(2, 3)};
  const SolveReport report = solve(graph);
  EXPECT_EQ(report.status, SolveStatus::kConverged);
  EXPECT_THAT(report.message, testing::HasSubstr("2 nodes are held"));
  EXPECT_NEAR(graph.poses[1].x, 1.0, 1e-9);
  EXPECT_EQ(graph.poses[2].x, 7.0);
  EXPECT_NEAR(graph.poses[3].x, 8.0, 1e-9);
}

TEST(SolverHostile, ZeroInformationIsAReason) {
  PoseGraph graph;
  graph.poses = {{}, {0.5, 0.0, 0.0}};
  graph.constraints = {tie(0, 1)};
  graph.constraints[0].information.setZero();
  EXPECT_EQ(solve(graph).status, SolveStatus::kFailed);
  EXPECT_EQ(graph.poses[1].x, 0.5);
}

TEST(SolverHostile, PosesThatAreNotFiniteMoveNothing) {
  PoseGraph graph;
  graph.poses = {{}, {std::nan(""), 0.0, 0.0}, {2.0, 0.0, 0.0}};
  graph.constraints = {tie(0, 1), tie(1, 2)};
  const SolveReport report = solve(graph);
  EXPECT_EQ(report.status, SolveStatus::kFailed);
  EXPECT_THAT(report.message, testing::HasSubstr("not finite"));
  EXPECT_EQ(graph.poses[2].x, 2.0);
}

TEST(SolverHostile, FaultsOfConstraintsAreNamed) {
  EXPECT_EQ(faultOf(tie(0, 1), 2), "");
  EXPECT_THAT(faultOf(tie(0, 2), 2), testing::HasSubstr("unknown node"));
  EXPECT_THAT(faultOf(tie(1, 1), 2), testing::HasSubstr("itself"));
  Constraint bad = tie(0, 1);
  bad.T_from_to.theta = std::nan("");
  EXPECT_THAT(faultOf(bad, 2), testing::HasSubstr("not finite"));
  bad = tie(0, 1);
  bad.information(1, 1) = -1.0;
  EXPECT_THAT(faultOf(bad, 2), testing::HasSubstr("positive"));
  bad = tie(0, 1);
  bad.information(0, 1) = 0.5;
  EXPECT_THAT(faultOf(bad, 2), testing::HasSubstr("symmetric"));
  bad.information(1, 0) = bad.information(0, 1) = std::nan("");
  EXPECT_THAT(faultOf(bad, 2), testing::HasSubstr("not finite"));
  bad = tie(0, 1);
  bad.information.setZero();
  EXPECT_THAT(faultOf(bad, 2), testing::HasSubstr("zero"));
}

TEST(SolverHostile, SenselessConfigurationIsNamed) {
  SolverConfig config;
  config.limits.max_iterations = 0;
  config.limits.relative_gain = 2.0;
  config.kernels.loop.width = std::nan("");
  EXPECT_EQ(config.validate().size(), 3U);
}

}  // namespace
}  // namespace omega_slam::graph

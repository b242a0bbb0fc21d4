#include "omega_slam/graph/robust_loops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/false_loops.h"
#include "support/graphs.h"

namespace omega_slam::graph {
namespace {

using testing::HasSubstr;

Constraint tie(NodeId from, NodeId to, double x, ConstraintKind kind = ConstraintKind::kOdometry) {
  return test::tie(from, to, {x, 0.0, 0.0}, 1e4, kind);
}

PoseGraph drive(NodeId nodes) {
  PoseGraph graph;
  graph.poses.resize(nodes);
  for (NodeId i = 0; i + 1 < nodes; ++i) {
    graph.constraints.push_back(tie(i, i + 1, 1.0));
  }
  return graph;
}

bool isFinite(const PoseGraph& graph) {
  return std::all_of(graph.poses.begin(), graph.poses.end(),
                     [](const geometry::Pose2& pose) { return pose.isFinite(); });
}

TEST(RobustLoopsHostile, NothingToSolve) {
  PoseGraph graph;
  EXPECT_EQ(solveWithDoubtfulLoops(graph).solution.status, SolveStatus::kConverged);
  graph.poses.resize(1);
  EXPECT_TRUE(solveWithDoubtfulLoops(graph).loops.empty());
}

TEST(RobustLoopsHostile, NoLoopsAtAll) {
  PoseGraph graph = drive(6);
  const RobustReport report = solveWithDoubtfulLoops(graph);
  EXPECT_EQ(report.solution.status, SolveStatus::kConverged);
  EXPECT_NEAR(graph.poses[5].x, 5.0, 1e-9);
}

TEST(RobustLoopsHostile, WrongConfigurationNamesAllFaults) {
  RobustConfig config;
  config.gate = -1.0;
  config.accidents = std::numeric_limits<double>::quiet_NaN();
  config.max_rounds = 0;
  PoseGraph graph = drive(3);
  try {
    solveWithDoubtfulLoops(graph, config);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("gate"));
    EXPECT_THAT(error.what(), HasSubstr("accidents"));
    EXPECT_THAT(error.what(), HasSubstr("max_rounds"));
  }
}

TEST(RobustLoopsHostile, WhatIsNotFiniteIsAReason) {
  PoseGraph graph = drive(4);
  graph.constraints.push_back(tie(0, 3, 3.0, ConstraintKind::kLoop));
  graph.constraints.back().T_from_to.y = std::numeric_limits<double>::quiet_NaN();
  const RobustReport report = solveWithDoubtfulLoops(graph);
  EXPECT_EQ(report.solution.status, SolveStatus::kFailed);
  EXPECT_THAT(report.solution.message, HasSubstr("not finite"));
  EXPECT_TRUE(isFinite(graph));
}

TEST(RobustLoopsHostile, PartsThatOnlyLoopsTieTogetherAreTied) {
  PoseGraph graph = drive(8);
  graph.constraints.erase(graph.constraints.begin() + 3);
  graph.constraints.push_back(tie(1, 5, 4.0, ConstraintKind::kLoop));
  graph.constraints.push_back(tie(2, 6, 4.0, ConstraintKind::kLoop));
  graph.constraints.push_back(tie(0, 7, -20.0, ConstraintKind::kLoop));
  const RobustReport report = solveWithDoubtfulLoops(graph);
  ASSERT_EQ(report.loops.size(), 3U);
  EXPECT_EQ(report.loops[0].standing, LoopStanding::kOnlyTie);
  EXPECT_EQ(report.loops[1].standing, LoopStanding::kConfirmed);
  EXPECT_EQ(report.loops[2].standing, LoopStanding::kContradicted);
  EXPECT_NEAR(graph.poses[7].x, 7.0, 1e-6);
}

TEST(RobustLoopsHostile, LoopsAlone) {
  PoseGraph graph;
  graph.poses.resize(4);
  for (NodeId i = 0; i < 3; ++i) {
    graph.constraints.push_back(tie(i, i + 1, 1.0, ConstraintKind::kLoop));
  }
  EXPECT_EQ(solveWithDoubtfulLoops(graph).solution.status, SolveStatus::kConverged);
  EXPECT_NEAR(graph.poses[3].x, 3.0, 1e-9);
}

TEST(RobustLoopsHostile, AllLoopsAreFalse) {
  std::mt19937_64 random(4);
  auto problem = test::drivenRounds({}, random);
  auto& constraints = problem.graph.constraints;
  constraints.resize(problem.truth.size());  // one loop is left: the pattern for the false ones
  test::addFalseLoops(problem, 60, 1, random);
  constraints.erase(constraints.begin() + static_cast<std::ptrdiff_t>(problem.truth.size()) - 1);
  const RobustReport report = solveWithDoubtfulLoops(problem.graph);
  for (const LoopVerdict& loop : report.loops) {
    EXPECT_FALSE(loop.isBelieved()) << toString(loop.standing) << " " << loop.squared;
  }
}

TEST(RobustLoopsHostile, SameLoopManyTimes) {
  PoseGraph graph = drive(30);
  for (int i = 0; i < 200; ++i) {
    graph.constraints.push_back(tie(2, 25, 23.01, ConstraintKind::kLoop));
  }
  EXPECT_EQ(solveWithDoubtfulLoops(graph).solution.status, SolveStatus::kConverged);
  EXPECT_NEAR(graph.poses[29].x, 29.0, 0.1);
}

TEST(RobustLoopsHostile, LoopThatKnowsNothingOfADirectionIsNotBelieved) {
  PoseGraph graph = drive(10);
  graph.constraints.push_back(tie(0, 9, 9.0, ConstraintKind::kLoop));
  graph.constraints.back().information(1, 1) = 0.0;
  const RobustReport report = solveWithDoubtfulLoops(graph);
  EXPECT_EQ(report.solution.status, SolveStatus::kConverged);
  EXPECT_EQ(report.loops[0].standing, LoopStanding::kUnconfirmed);
  EXPECT_TRUE(isFinite(graph));
}

TEST(RobustLoopsHostile, SingularOdometryLeavesThePosesAlone) {
  PoseGraph graph = drive(4);
  graph.constraints[1].information.setZero();
  graph.constraints[1].information(0, 0) = 1.0;
  graph.poses[3].x = 17.0;
  const RobustReport report = solveWithDoubtfulLoops(graph);
  EXPECT_EQ(report.solution.status, SolveStatus::kFailed);
  EXPECT_THAT(report.solution.message, HasSubstr("singular"));
  EXPECT_EQ(graph.poses[3].x, 17.0);
}

TEST(RobustLoopsHostile, HeldNodesStay) {
  PoseGraph graph = drive(12);
  graph.held = {3, 9};
  graph.poses[3] = {1.0, 2.0, 0.0};
  graph.poses[9] = {7.05, 2.0, 0.0};
  graph.constraints.push_back(tie(3, 9, 6.0, ConstraintKind::kLoop));
  graph.constraints.push_back(tie(0, 11, 11.0, ConstraintKind::kLoop));
  EXPECT_EQ(solveWithDoubtfulLoops(graph).solution.status, SolveStatus::kConverged);
  EXPECT_EQ(graph.poses[3].x, 1.0);
  EXPECT_EQ(graph.poses[9].x, 7.05);
  EXPECT_NEAR(graph.poses[6].x, 4.025, 1e-3);
}

TEST(RobustLoopsHostile, PartsThatAreHeldNeedNoTie) {
  PoseGraph graph = drive(8);
  graph.constraints.erase(graph.constraints.begin() + 3);
  graph.held = {0, 4};
  graph.poses[4] = {4.0, 0.0, 0.0};
  graph.constraints.push_back(tie(1, 5, -20.0, ConstraintKind::kLoop));
  graph.constraints.push_back(tie(2, 6, 4.0, ConstraintKind::kLoop));
  const RobustReport report = solveWithDoubtfulLoops(graph);
  EXPECT_EQ(report.loops[0].standing, LoopStanding::kContradicted);
  EXPECT_EQ(report.loops[1].standing, LoopStanding::kConfirmed);
}

TEST(RobustLoopsHostile, RoundsThatRunOutAreSaid) {
  std::mt19937_64 random(6);
  auto problem = test::drivenRounds({}, random);
  RobustConfig config;
  config.max_rounds = 2;
  const RobustReport report = solveWithDoubtfulLoops(problem.graph, config);
  EXPECT_EQ(report.solution.status, SolveStatus::kIterationLimit);
  EXPECT_THAT(report.solution.message, HasSubstr("after 2 rounds"));
  EXPECT_TRUE(isFinite(problem.graph));
}

}  // namespace
}  // namespace omega_slam::graph

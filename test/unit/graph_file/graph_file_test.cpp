#include "omega_slam/graph/graph_file.h"

#include <gtest/gtest.h>

#include "omega_slam/geometry/angle.h"
#include "support/temporary_folder.h"

namespace omega_slam::graph {
namespace {

PoseGraph smallGraph() {
  PoseGraph graph;
  graph.poses = {{0, 0, 0}, {1, 0.1, 0.5}, {2, -0.25, -3}};
  Constraint step;
  step.from = 0;
  step.to = 1;
  step.T_from_to = {1, 0.1, 0.5};
  step.information << 4, 1, 0.5, 1, 5, 0.25, 0.5, 0.25, 6;
  Constraint loop = step;
  loop.from = 2;
  loop.to = 0;
  loop.kind = ConstraintKind::kLoop;
  graph.constraints = {step, loop};
  return graph;
}

TEST(GraphFile, WritesG2o) {
  EXPECT_EQ(toG2o(smallGraph()),
            "VERTEX_SE2 0 0 0 0\n"
            "VERTEX_SE2 1 1 0.10000000000000001 0.5\n"
            "VERTEX_SE2 2 2 -0.25 -3\n"
            "FIX 0\n"
            "EDGE_SE2 0 1 1 0.10000000000000001 0.5 4 1 0.5 5 0.25 6\n"
            "EDGE_SE2 2 0 1 0.10000000000000001 0.5 4 1 0.5 5 0.25 6\n");
}

TEST(GraphFile, ReadsTheUpperTriangleRowByRow) {
  const PoseGraph graph = readGraph(toG2o(smallGraph()), "g").graph;
  Eigen::Matrix3d expected;
  expected << 4, 1, 0.5, 1, 5, 0.25, 0.5, 0.25, 6;
  ASSERT_EQ(graph.constraints.size(), 2U);
  EXPECT_EQ(graph.constraints[0].information, expected);
  EXPECT_EQ(graph.constraints[1].from, 2U);
  EXPECT_EQ(graph.constraints[1].to, 0U);
}

TEST(GraphFile, FromAPoseToTheNextIsOdometryOthersAreLoops) {
  const PoseGraph graph = readGraph(
                              "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 0 0 0\nVERTEX_SE2 2 0 0 0\n"
                              "EDGE_SE2 0 1 0 0 0 1 0 0 1 0 1\nEDGE_SE2 2 1 0 0 0 1 0 0 1 0 1\n"
                              "EDGE_SE2 0 2 0 0 0 1 0 0 1 0 1\n",
                              "g")
                              .graph;
  EXPECT_EQ(graph.constraints[0].kind, ConstraintKind::kOdometry);
  EXPECT_EQ(graph.constraints[1].kind, ConstraintKind::kOdometry);
  EXPECT_EQ(graph.constraints[2].kind, ConstraintKind::kLoop);
}

TEST(GraphFile, GapsInIdsAreClosedInOrder) {
  const PoseGraph graph =
      readGraph(
          "VERTEX_SE2 70 7 0 0\nVERTEX_SE2 5 0.5 0 0\nEDGE_SE2 70 5 0 0 0 1 0 0 1 0 1\nFIX 5\n",
          "g")
          .graph;
  ASSERT_EQ(graph.poses.size(), 2U);
  EXPECT_EQ(graph.poses[0].x, 0.5);
  EXPECT_EQ(graph.poses[1].x, 7.0);
  EXPECT_EQ(graph.constraints[0].from, 1U);
  EXPECT_EQ(graph.constraints[0].to, 0U);
  EXPECT_EQ(graph.constraints[0].kind, ConstraintKind::kOdometry);  // none is between them
}

TEST(GraphFile, EdgesAloneAreChained) {
  const PoseGraph graph = readGraph(
                              "EDGE_SE2 0 1 1 0 1.5707963267948966 1 0 0 1 0 1\n"
                              "EDGE_SE2 2 1 -2 0 0 1 0 0 1 0 1\n"
                              "EDGE_SE2 0 2 9 9 0 1 0 0 1 0 1\n",
                              "g")
                              .graph;
  ASSERT_EQ(graph.poses.size(), 3U);
  EXPECT_NEAR(graph.poses[2].x, 1.0, 1e-12);
  EXPECT_NEAR(graph.poses[2].y, 2.0, 1e-12);
  EXPECT_NEAR(graph.poses[2].theta, geometry::kPi / 2, 1e-12);
}

TEST(GraphFile, CommentsBlankLinesAndWindowsEndingsAreFine) {
  const PoseGraph graph = readGraph("# a graph\r\n\r\nVERTEX_SE2 0 1 2 3\r\n   \nFIX 0", "g").graph;
  ASSERT_EQ(graph.poses.size(), 1U);
  EXPECT_EQ(graph.poses[0].theta, 3.0);
}

TEST(GraphFile, WhatItIsReadAsIsWritten) {
  const std::string text =
      "VERTEX_SE2 3 0 0 0\nVERTEX_SE2 5 1 0 0\nVERTEX_XY 9 1 2\nFIX 5\nFIX 3\n"
      "EDGE_SE2 3 5 1 0 0 1 0 0 1 0 1\nEDGE_SE2_XY 5 9 0.5 2 4 1 3\n";
  const GraphFile file = readGraph(text, "g");
  EXPECT_EQ(file.ids, (std::vector<NodeId>{3, 5, 9}));
  EXPECT_EQ(file.graph.held, (std::vector<NodeId>{1, 0}));
  EXPECT_EQ(file.graph.points, (std::vector<NodeId>{2}));
  EXPECT_EQ(file.graph.constraints[1].kind, ConstraintKind::kLandmark);
  EXPECT_EQ(toG2o(file), text);
}

TEST(GraphFile, ToroHasAnotherOrderOfInformation) {
  const GraphFile file{smallGraph(), {}};
  const std::string text = toToro(file);
  EXPECT_EQ(text.substr(0, text.find('\n')), "VERTEX2 0 0 0 0");
  EXPECT_NE(text.find("EDGE2 0 1 1 0.10000000000000001 0.5 4 1 5 6 0.5 0.25\n"), std::string::npos);
  const PoseGraph again = readGraph(text, "t").graph;
  EXPECT_EQ(again.constraints[1].information, file.graph.constraints[1].information);
  EXPECT_EQ(toText(file, "x.graph"), text);
  EXPECT_EQ(toText(file, "x.g2o"), toG2o(file));
  GraphFile with_points = file;
  with_points.graph.points = {2};
  EXPECT_THROW(static_cast<void>(toToro(with_points)), std::invalid_argument);
}

TEST(GraphFile, AnEmptyGraphIsAnEmptyText) {
  EXPECT_EQ(toG2o(PoseGraph{}), "");
  EXPECT_TRUE(readGraph("", "g").graph.poses.empty());
}

TEST(GraphFile, LoadsFromAFile) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(loadGraph(folder.write("g.g2o", toG2o(smallGraph()))).graph.poses.size(), 3U);
}

}  // namespace
}  // namespace omega_slam::graph

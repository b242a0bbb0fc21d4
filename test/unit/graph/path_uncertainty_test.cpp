#include "omega_slam/graph/path_uncertainty.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/chains.h"

namespace omega_slam::graph {
namespace {

using geometry::Pose2;

/// Straight on, a metre a step.
std::vector<Pose2> straight(int nodes) {
  std::vector<Pose2> poses;
  for (int i = 0; i < nodes; ++i) {
    poses.push_back({static_cast<double>(i), 0.0, 0.0});
  }
  return poses;
}

TEST(PathUncertainty, TheRootIsKnown) {
  const PoseGraph graph = test::chainOf(straight(3), 0.1);
  PathUncertainty known(graph, 1);
  EXPECT_EQ(known.hops(1), 0);
  EXPECT_EQ(known.placeDeviation(1), 0.0);
  EXPECT_EQ(known.headingDeviation(1), 0.0);
}

TEST(PathUncertainty, GrowsAlongAChainAsTheTextbookCompounds) {
  const double deviation = 0.1;
  const PoseGraph graph = test::chainOf(straight(3), deviation);
  PathUncertainty known(graph, 0);
  EXPECT_EQ(known.hops(2), 2);
  EXPECT_NEAR(known.headingDeviation(2), deviation * std::sqrt(2.0), 1e-12);
  // Along the way the two steps add up; across it the first one's turn moves the second metre too.
  const Eigen::Matrix3d& covariance = known.covariance(2);
  EXPECT_NEAR(covariance(0, 0), 2.0 * deviation * deviation, 1e-12);
  EXPECT_NEAR(covariance(1, 1), 3.0 * deviation * deviation, 1e-12);
}

TEST(PathUncertainty, TheWayBackIsAsUncertainAsTheWayThere) {
  auto poses = straight(2);
  poses[1].theta = 0.7;
  const PoseGraph graph = test::chainOf(poses, 0.1);
  PathUncertainty there(graph, 0);
  PathUncertainty back(graph, 1);
  // An inverse's covariance is that of the pose, seen from the other end: as large where a turn
  // does not move it.
  EXPECT_NEAR(back.headingDeviation(0), there.headingDeviation(1), 1e-12);
  EXPECT_NEAR((back.covariance(0).topLeftCorner<2, 2>().trace()), 0.01 + 0.01 + 0.01, 1e-12);
}

TEST(PathUncertainty, ALoopIsAShortCut) {
  PoseGraph graph = test::chainOf(straight(30), 0.1);
  const double by_chain = PathUncertainty(graph, 0).placeDeviation(29);
  Constraint loop;
  loop.from = 0;
  loop.to = 29;
  loop.T_from_to = relativePose(graph.poses[0], graph.poses[29]);
  loop.information = Eigen::Matrix3d::Identity() / (0.05 * 0.05);
  graph.constraints.push_back(loop);
  PathUncertainty known(graph, 0);
  EXPECT_GT(by_chain, 1.0);
  EXPECT_NEAR(known.placeDeviation(29), 0.05, 1e-12);
  EXPECT_EQ(known.hops(29), 1);
}

TEST(PathUncertainty, AnswersDoNotDependOnWhatWasAskedBefore) {
  PoseGraph graph = test::chainOf(straight(12), 0.1);
  Constraint loop = graph.constraints.front();
  loop.from = 2;
  loop.to = 9;
  loop.T_from_to = relativePose(graph.poses[2], graph.poses[9]);
  graph.constraints.push_back(loop);
  PathUncertainty outwards(graph, 3);
  PathUncertainty inwards(graph, 3);
  std::vector<double> deviations;
  for (NodeId node = 0; node < 12; ++node) {
    deviations.push_back(outwards.placeDeviation(node));
  }
  for (NodeId node = 12; node-- > 0;) {
    EXPECT_EQ(inwards.placeDeviation(node), deviations[node]);
    EXPECT_EQ(inwards.hops(node), PathUncertainty(graph, 3).hops(node));
  }
  EXPECT_EQ(inwards.hops(9), 2);
}

TEST(PathUncertainty, WhatIsNotTiedIsNotReached) {
  PoseGraph graph = test::chainOf(straight(3), 0.1);
  graph.constraints[1].information.setZero();  // says nothing
  PathUncertainty known(graph, 0);
  EXPECT_TRUE(known.reaches(1));
  EXPECT_FALSE(known.reaches(2));
  EXPECT_TRUE(std::isinf(known.placeDeviation(2)));
  EXPECT_TRUE(std::isinf(known.headingDeviation(2)));
}

}  // namespace
}  // namespace omega_slam::graph

#include "omega_slam/graph/retired_nodes.h"

#include <gtest/gtest.h>

#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/solver.h"
#include "omega_slam/graph/thinning.h"
#include "support/graphs.h"
#include "support/poses.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

using geometry::Pose2;

/// Whatever small error there is, it costs the same; to first order where `to` has retired.
TEST(RetiredNodesLaws, ACarriedConstraintCostsWhatItDid) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    PoseGraph graph;
    for (int i = 0; i < 4; ++i) {
      graph.poses.push_back(test::randomPose(5.0, 3.0, random));
    }
    RetiredNodes retired;
    retired.add({1, 2, relativePose(graph.poses[2], graph.poses[1]), 0.0});
    for (const bool is_to : {true, false}) {
      Constraint constraint;
      constraint.from = is_to ? 0 : 1;
      constraint.to = is_to ? 1 : 3;
      constraint.T_from_to =
          relativePose(graph.poses[constraint.from], graph.poses[constraint.to]) *
          test::randomPose(1e-4, 1e-4, random);
      constraint.information = test::randomInformation(random);
      const Constraint carried = retired.carried(constraint);
      EXPECT_EQ(carried.from, is_to ? 0U : 2U);
      EXPECT_EQ(carried.to, is_to ? 2U : 3U);
      const double cost = chiSquare(graph, constraint);
      EXPECT_NEAR(chiSquare(graph, carried), cost, 1e-2 * cost);
    }
  }
}

TEST(RetiredNodesLaws, AnchorsThatRetireHandOverWhatGoesWithThem) {
  std::mt19937_64 random(3);
  std::vector<Pose2> poses;
  for (int i = 0; i < 3; ++i) {
    poses.push_back(test::randomPose(5.0, 3.0, random));
  }
  RetiredNodes retired;
  retired.add({0, 1, relativePose(poses[1], poses[0]), 0.0});
  retired.add({1, 2, relativePose(poses[2], poses[1]), 0.0});
  const Pose2 motion = test::randomPose(2.0, 2.0, random);
  std::vector<Pose2> moved = poses;
  moved[2] = motion * poses[2];
  retired.follow(moved, [&](NodeId node, const Pose2& T_map_node) { moved[node] = T_map_node; });
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LT(test::gapBetween(moved[i], motion * poses[i]).translation, 1e-9);
    EXPECT_LT(test::gapBetween(moved[i], motion * poses[i]).rotation, 1e-9);
  }
}

/// Retiring differs from removing by nothing but the numbers.
TEST(RetiredNodesLaws, WhatIsLeftIsWhatARemovalLeaves) {
  std::mt19937_64 random(5);
  PoseGraph retired = test::randomWalk({20, 10, 0.02, 0.0}, random).graph;
  solve(retired);
  PoseGraph removed = retired;
  const auto retirement = retireNode(retired, 7, 100.0);
  ASSERT_TRUE(retirement);
  EXPECT_EQ(removeNode(removed, 7, 100.0), retirement->divergence);
  EXPECT_EQ(retired.held, (std::vector<NodeId>{0, 7}));
  EXPECT_EQ(retired.poses.size(), 20U);
  ASSERT_EQ(retired.constraints.size(), removed.constraints.size());
  EXPECT_EQ(chiSquare(retired), chiSquare(removed));
  const SolveReport report = solve(retired);
  EXPECT_EQ(report.message, "") << "a retired node is no lost part";
  EXPECT_NEAR(report.chi_square, solve(removed).chi_square, 1e-6);
}

}  // namespace
}  // namespace omega_slam::graph

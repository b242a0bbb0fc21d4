#include "omega_slam/graph/neighbourhood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/graphs.h"

namespace omega_slam::graph {
namespace {

/// 0 - 1 - 2 - ... - 9, a metre each.
PoseGraph chain() {
  PoseGraph graph;
  for (NodeId i = 0; i < 10; ++i) {
    graph.poses.push_back({1.0 * i, 0.0, 0.0});
    if (i > 0) {
      graph.constraints.push_back(test::tie(i - 1, i));
    }
  }
  return graph;
}

TEST(Neighbourhood, ReachesAsFarAsToldAndHoldsItsRim) {
  const PoseGraph graph = chain();
  const Neighbourhood near(graph, {test::tie(4, 5)}, 2);
  const PoseGraph part = near.of(graph);
  EXPECT_EQ(near.size(), 6U);  // 2 to 7
  EXPECT_EQ(part.constraints.size(), 5U);
  ASSERT_EQ(part.held.size(), 2U);
  std::vector<double> held{part.poses[part.held[0]].x, part.poses[part.held[1]].x};
  std::sort(held.begin(), held.end());
  EXPECT_EQ(held, (std::vector<double>{2.0, 7.0}));
  for (const Constraint& constraint : part.constraints) {
    EXPECT_EQ(part.poses[constraint.to].x - part.poses[constraint.from].x, 1.0);
  }
}

TEST(Neighbourhood, HoldsWhatTheWholeHolds) {
  PoseGraph graph = chain();
  EXPECT_EQ(Neighbourhood(graph, {test::tie(0, 1)}, 3).of(graph).held.size(), 2U)
      << "4, and the first";
  graph.held = {5, 9};
  graph.points = {4, 8};
  const PoseGraph part = Neighbourhood(graph, {test::tie(4, 5)}, 2).of(graph);
  EXPECT_EQ(part.held.size(), 3U);
  ASSERT_EQ(part.points.size(), 1U);
  EXPECT_EQ(part.poses[part.points[0]].x, 4.0);
}

TEST(Neighbourhood, LeavesOutWhatTiesTheRimToItself) {
  PoseGraph graph = chain();
  graph.constraints.push_back(test::tie(2, 7));
  const Neighbourhood near(graph, {test::tie(4, 5)}, 2);
  EXPECT_EQ(near.of(graph).constraints.size(), 5U);
}

TEST(Neighbourhood, TellsHowFarItsOuterHalfHasMoved) {
  PoseGraph graph = chain();
  const Neighbourhood near(graph, {test::tie(4, 5)}, 4);
  PoseGraph part = near.of(graph);
  const auto at = [&](double x) {
    return std::find_if(part.poses.begin(), part.poses.end(),
                        [x](const geometry::Pose2& pose) { return pose.x == x; });
  };
  at(3.0)->y = 1.0;
  EXPECT_EQ(near.outerMotion(part, graph), 0.0);
  at(2.0)->y = 0.5;
  EXPECT_EQ(near.outerMotion(part, graph), 0.5);
  at(7.0)->theta = -0.7;
  EXPECT_EQ(near.outerMotion(part, graph), 14.0) << "20 m away";
  near.place(part, graph);
  EXPECT_EQ(graph.poses[2].y, 0.5);
  EXPECT_EQ(graph.poses[7].theta, -0.7);
  EXPECT_EQ(graph.poses[9].x, 9.0);
}

}  // namespace
}  // namespace omega_slam::graph

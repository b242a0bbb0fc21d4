#include "omega_slam/graph/estimated_part.h"

#include <gtest/gtest.h>

#include "support/graphs.h"

namespace omega_slam::graph {
namespace {

/// Nodes 0 and 3 are held and tied, 1 and 4 held and idle, 5 is neither.
PoseGraph graphWithIdleNodes() {
  PoseGraph graph;
  for (int node = 0; node < 6; ++node) {
    graph.poses.push_back({1.0 * node, 0.0, 0.0});
  }
  graph.held = {0, 4, 1, 3};
  graph.points = {2};
  graph.constraints = {test::tie(0, 2), test::tie(3, 2)};
  return graph;
}

TEST(EstimatedPartUnit, LacksWhatIsHeldAndTiedToNothing) {
  const PoseGraph whole = graphWithIdleNodes();
  const EstimatedPart part(whole);
  EXPECT_EQ(part.nodes(), (std::vector<NodeId>{0, 2, 3, 5}));
  EXPECT_FALSE(part.has(1));
  EXPECT_TRUE(part.has(5));
  EXPECT_FALSE(part.has(6));
  const PoseGraph graph = part.of(whole);
  ASSERT_EQ(graph.poses.size(), 4U);
  EXPECT_EQ(graph.poses[2].x, 3.0);
  EXPECT_EQ(graph.held, (std::vector<NodeId>{0, 2}));
  EXPECT_EQ(graph.points, (std::vector<NodeId>{1}));
  ASSERT_EQ(graph.constraints.size(), 2U);
  EXPECT_EQ(graph.constraints[1].from, 2U);
  EXPECT_EQ(graph.constraints[1].to, 1U);
}

TEST(EstimatedPartUnit, GrowsAndGivesPosesBack) {
  PoseGraph whole = graphWithIdleNodes();
  EstimatedPart part(whole);
  whole.poses.push_back({6.0, 0.0, 0.0});
  part.append(6);
  EXPECT_EQ(part.renumbered(test::tie(5, 6)).to, 4U);
  part.place({{10, 0, 0}, {12, 0, 0}, {13, 0, 0}, {15, 0, 0}, {16, 0, 0}}, whole);
  std::vector<double> x;
  for (const geometry::Pose2& pose : whole.poses) {
    x.push_back(pose.x);
  }
  EXPECT_EQ(x, (std::vector<double>{10, 1, 12, 13, 4, 15, 16}));
}

TEST(EstimatedPartUnit, OfAnEmptyGraphIsEmpty) {
  const EstimatedPart part{PoseGraph{}};
  EXPECT_EQ(part.size(), 0U);
  EXPECT_TRUE(part.of({}).poses.empty());
}

}  // namespace
}  // namespace omega_slam::graph

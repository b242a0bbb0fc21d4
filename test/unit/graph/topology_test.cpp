#include "omega_slam/graph/topology.h"

#include <gtest/gtest.h>

#include <set>

namespace omega_slam::graph {
namespace {

PoseGraph graphOf(std::size_t nodes, const std::vector<std::pair<NodeId, NodeId>>& ties) {
  PoseGraph graph;
  graph.poses.resize(nodes);
  for (const auto& [from, to] : ties) {
    Constraint constraint;
    constraint.from = from;
    constraint.to = to;
    constraint.T_from_to = {1.0, 0.0, 0.0};
    graph.constraints.push_back(constraint);
  }
  return graph;
}

const std::vector<std::pair<NodeId, NodeId>> kRing = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 4}};

TEST(SpanningForestTest, GrowsAlongTheFewestConstraints) {
  const SpanningForest forest = spanningForest(graphOf(5, kRing));
  EXPECT_EQ(forest.roots, (std::vector<NodeId>{0}));
  EXPECT_EQ(forest.by_constraint, (std::vector<std::size_t>{SpanningForest::kRoot, 0, 1, 3, 4}));
}

TEST(SpanningForestTest, GrowsAlongTheChain) {
  const SpanningForest forest = spanningForest(graphOf(5, kRing), Growth::kChain);
  EXPECT_EQ(forest.order, (std::vector<NodeId>{0, 1, 2, 3, 4}));
  EXPECT_EQ(forest.by_constraint, (std::vector<std::size_t>{SpanningForest::kRoot, 0, 1, 2, 3}));
}

TEST(SpanningForestTest, HeldNodesAreRootsAndPartsWithoutOneHaveTheirLowest) {
  PoseGraph graph = graphOf(8, {{0, 1}, {1, 2}, {4, 5}, {6, 5}});
  graph.held = {2, 0};
  const SpanningForest forest = spanningForest(graph);
  EXPECT_EQ(forest.roots, (std::vector<NodeId>{2, 0, 3, 4, 7}));
  EXPECT_EQ(std::set<NodeId>(forest.order.begin(), forest.order.end()).size(), 8U);
}

TEST(SpanningForestTest, PlacesAgainstAndAlongAConstraint) {
  PoseGraph graph = graphOf(3, {{0, 1}, {2, 0}});
  const SpanningForest forest = spanningForest(graph);
  EXPECT_EQ(poseByTree(graph, forest, 1).x, 1.0);
  EXPECT_EQ(poseByTree(graph, forest, 2).x, -1.0);
  EXPECT_EQ(poseByTree(graph, forest, 0).x, 0.0);
}

}  // namespace
}  // namespace omega_slam::graph

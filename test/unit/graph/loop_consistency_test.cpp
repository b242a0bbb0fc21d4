#include "omega_slam/graph/loop_consistency.h"

#include <gtest/gtest.h>

#include "support/graphs.h"

namespace omega_slam::graph {
namespace {

constexpr NodeId kNodes = 12;

Constraint tie(NodeId from, NodeId to, double x, ConstraintKind kind) {
  return test::tie(from, to, {x, 0.0, 0.0}, 100.0, kind);
}

Constraint loop(NodeId from, NodeId to, double x) {
  return tie(from, to, x, ConstraintKind::kLoop);
}

/// A straight drive in steps of a metre.
PoseGraph drive() {
  PoseGraph graph;
  graph.poses.resize(kNodes);
  for (NodeId i = 0; i + 1 < kNodes; ++i) {
    graph.constraints.push_back(tie(i, i + 1, 1.0, ConstraintKind::kOdometry));
  }
  return graph;
}

TEST(LoopConsistencyUnit, DisagreementCountsTheNoiseOfTheWholeCycle) {
  const OdometryChain chain(drive());
  // Two loops and two steps with a variance of 0.01 each along x. Both say that the ninth node is
  // where the first is.
  EXPECT_NEAR(*chain.disagreement(loop(0, 9, 0.0), loop(1, 10, 0.0)), 0.0, 1e-12);
  EXPECT_NEAR(*chain.disagreement(loop(0, 9, 0.0), loop(1, 10, 0.4)), 0.16 / 0.04, 1e-6);
  EXPECT_NEAR(*chain.disagreement(loop(0, 9, 0.0), loop(0, 9, 0.4)), 0.16 / 0.02, 1e-6);
}

TEST(LoopConsistencyUnit, LoopsMayBeNamedBackwards) {
  const OdometryChain chain(drive());
  EXPECT_NEAR(*chain.disagreement(loop(0, 9, 0.5), loop(10, 1, -0.5)), 0.0, 1e-12);
  EXPECT_EQ(OdometryChain::separation(loop(0, 9, 0.0), loop(11, 1, 0.0)), 2U);
}

TEST(LoopConsistencyUnit, SurestOfSeveralStepsCounts) {
  PoseGraph graph = drive();
  Constraint surer = tie(0, 1, 2.0, ConstraintKind::kMatch);
  surer.information *= 10.0;
  graph.constraints.push_back(surer);
  graph.constraints.push_back(loop(1, 2, 7.0));
  EXPECT_NEAR(*OdometryChain(graph).disagreement(loop(0, 9, 0.0), loop(1, 9, -2.0)), 0.0, 1e-12);
}

TEST(LoopConsistencyUnit, NothingIsSaidAcrossAMissingStep) {
  PoseGraph graph = drive();
  graph.constraints.erase(graph.constraints.begin() + 4);
  const OdometryChain chain(graph);
  EXPECT_FALSE(chain.disagreement(loop(4, 9, 0.0), loop(5, 10, 0.0)));
  EXPECT_TRUE(chain.disagreement(loop(3, 9, 0.0), loop(4, 10, 0.0)));
}

TEST(LoopConsistencyUnit, SupportOfANewLoopIsCountedAmongNearOnes) {
  const OdometryChain chain(drive());
  const std::vector<Constraint> others = {loop(0, 8, 0.0), loop(2, 10, 5.0), loop(6, 11, 0.0)};
  const LoopSupport support = supportOf(loop(1, 9, 0.0), others, chain, {2, 4.0});
  EXPECT_EQ(support.agreeing, 1U);
  EXPECT_EQ(support.disagreeing, 1U);
}

TEST(LoopConsistencyUnit, AgreementIsMutualAndOfNearLoops) {
  PoseGraph graph = drive();
  graph.constraints.push_back(loop(1, 9, 0.0));
  graph.constraints.push_back(loop(0, 8, 0.0));
  graph.constraints.push_back(loop(2, 10, 5.0));
  graph.constraints.push_back(loop(5, 11, 2.0));
  const auto agreeing = agreeingLoops(graph, {11, 12, 13, 14}, {2, 4.0});
  EXPECT_EQ(agreeing[0], std::vector<std::size_t>{1});
  EXPECT_EQ(agreeing[1], std::vector<std::size_t>{0});
  EXPECT_TRUE(agreeing[2].empty());
  EXPECT_TRUE(agreeing[3].empty());
}

}  // namespace
}  // namespace omega_slam::graph

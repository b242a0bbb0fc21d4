#include "omega_slam/graph/thinning.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/graph/marginals.h"
#include "omega_slam/graph/solver.h"
#include "support/graphs.h"
#include "support/poses.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

constexpr double kAnything = std::numeric_limits<double>::infinity();

SolverConfig plain() {
  SolverConfig config;
  config.kernels.loop.kind = KernelKind::kNone;
  config.limits = {100, 1e-12};
  return config;
}

KernelConfig noKernels() { return plain().kernels; }

PoseGraph solvedWalk(const test::WalkConfig& config, std::mt19937_64& random) {
  PoseGraph graph = test::randomWalk(config, random).graph;
  solve(graph, plain());
  return graph;
}

/// Nothing was known that two constraints in a row do not say.
TEST(ThinningLaws, ANodeOnAChainLosesNothing) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    PoseGraph graph = test::randomWalk({12, 0, 0.05, 0.0}, random).graph;
    graph.constraints.push_back(test::measure(graph.poses, 0, 11, 0.05, random));
    solve(graph, plain());
    const PoseGraph before = graph;
    const Eigen::Matrix3d known = Marginals(before, noKernels()).covariance(8);
    const auto lost = removeNode(graph, 5, kAnything);
    ASSERT_TRUE(lost);
    EXPECT_NEAR(*lost, 0.0, 1e-9);
    EXPECT_EQ(graph.poses.size(), 11U);
    EXPECT_EQ(graph.constraints.size(), before.constraints.size() - 1);
    EXPECT_LT((Marginals(graph, noKernels()).covariance(7) - known).norm(), 1e-6 * known.norm());
    solve(graph, plain());
    EXPECT_LT(test::gapBetween(graph.poses[7], before.poses[8]).translation, 1e-3);
  }
}

TEST(ThinningLaws, ALeafGoesWithoutATrace) {
  std::mt19937_64 random(3);
  PoseGraph graph = solvedWalk({8, 0, 0.05, 0.0}, random);
  EXPECT_EQ(removeNode(graph, 7, 0.0).value_or(-1.0), 0.0);
  EXPECT_EQ(graph.poses.size(), 7U);
  EXPECT_EQ(graph.constraints.size(), 6U);
}

/// The solution stays where it was, and the rest stays about as well known.
TEST(ThinningLaws, ANodeAmongManyMovesTheOthersLittle) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    PoseGraph graph = solvedWalk({40, 60, 0.02, 0.0}, random);
    const PoseGraph before = graph;
    const Eigen::Matrix3d known = Marginals(before, noKernels()).covariance(30);
    const auto lost = removeNode(graph, 20, kAnything);
    ASSERT_TRUE(lost);
    EXPECT_GE(*lost, 0.0);
    solve(graph, plain());
    const Eigen::Matrix3d still_known = Marginals(graph, noKernels()).covariance(29);
    EXPECT_LT(test::gapBetween(graph.poses[29], before.poses[30]).translation,
              std::sqrt(known.topLeftCorner<2, 2>().trace()));
    EXPECT_NEAR(still_known.determinant() / known.determinant(), 1.0, 0.7);
  }
}

TEST(ThinningLaws, WhatWouldLoseTooMuchStays) {
  std::mt19937_64 random(4);
  PoseGraph graph = solvedWalk({20, 60, 0.02, 0.0}, random);
  const PoseGraph before = graph;
  EXPECT_FALSE(removeNode(graph, 10, 1e-6));
  EXPECT_EQ(graph.poses.size(), before.poses.size());
  EXPECT_EQ(graph.constraints.size(), before.constraints.size());
}

TEST(ThinningLaws, HeldNodesAndThoseThatSeePointsStay) {
  std::mt19937_64 random(5);
  PoseGraph graph = solvedWalk({20, 5, 0.02, 0.0}, random);
  graph.held = {3};
  EXPECT_FALSE(removeNode(graph, 3, kAnything));
  graph.poses.push_back({1.0, 1.0, 0.0});
  graph.points = {20};
  Constraint sight;
  sight.from = 6;
  sight.to = 20;
  sight.kind = ConstraintKind::kLandmark;
  graph.constraints.push_back(sight);
  EXPECT_FALSE(removeNode(graph, 6, kAnything));
  EXPECT_FALSE(removeNode(graph, 20, kAnything));
  EXPECT_TRUE(removeNode(graph, 2, kAnything));
  EXPECT_EQ(graph.held, (std::vector<NodeId>{2}));
  EXPECT_EQ(graph.points, (std::vector<NodeId>{19}));
  EXPECT_EQ(graph.constraints.back().kind, ConstraintKind::kMatch);
}

/// A robot that drives round and round: the graph stops growing, and its path stays.
TEST(ThinningLaws, AGraphGrowsWithTheAreaNotWithTheTime) {
  std::mt19937_64 random(6);
  constexpr int kNodesARound = 24;
  constexpr int kRounds = 12;
  std::vector<geometry::Pose2> truth;
  for (int i = 0; i < kRounds * kNodesARound; ++i) {
    const double angle = 2.0 * geometry::kPi * i / kNodesARound;
    truth.push_back({2.0 * std::cos(angle), 2.0 * std::sin(angle),
                     geometry::normalizeAngle(angle + 0.5 * geometry::kPi)});
  }
  PoseGraph graph;
  graph.poses = truth;
  for (NodeId i = 1; i < truth.size(); ++i) {
    graph.constraints.push_back(test::measure(truth, i - 1, i, 0.02, random));
    if (i >= kNodesARound) {
      graph.constraints.push_back(test::measure(truth, i - kNodesARound, i, 0.02, random));
    }
  }
  solve(graph, plain());
  const PoseGraph before = graph;
  ThinningConfig config;
  config.newest = kNodesARound;
  const ThinningReport report = thinOut(graph, config);
  EXPECT_EQ(report.kept.size(), graph.poses.size());
  EXPECT_LT(graph.poses.size(), std::size_t{6 * kNodesARound});
  EXPECT_LT(graph.constraints.size(), 3 * graph.poses.size());
  EXPECT_EQ(report.kept.front(), 0U);
  EXPECT_EQ(report.kept.back(), truth.size() - 1);
  EXPECT_EQ(solve(graph, plain()).status, SolveStatus::kConverged);
  for (std::size_t i = 0; i < graph.poses.size(); ++i) {
    EXPECT_LT(test::gapBetween(graph.poses[i], before.poses[report.kept[i]]).translation, 0.05);
  }
}

}  // namespace
}  // namespace omega_slam::graph

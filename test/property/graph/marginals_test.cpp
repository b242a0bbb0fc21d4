#include "omega_slam/graph/marginals.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/solver.h"
#include "support/graphs.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

constexpr NodeId kNodes = 30;

KernelConfig noKernels() {
  KernelConfig kernels;
  kernels.loop.kind = KernelKind::kNone;
  return kernels;
}

PoseGraph solvedWalk(std::mt19937_64& random) {
  PoseGraph graph = test::randomWalk({kNodes, 12, 0.05, 0.1}, random).graph;
  solve(graph);
  return graph;
}

/// The inverse of Omega without node 0, whole.
Eigen::MatrixXd denseCovariance(const PoseGraph& graph) {
  Eigen::MatrixXd omega = Eigen::MatrixXd::Zero(3 * kNodes, 3 * kNodes);
  for (const Constraint& constraint : graph.constraints) {
    const LinearizedConstraint at = linearize(constraint, graph);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, 3 * kNodes);
    jacobian.middleCols<3>(3 * constraint.from) = at.J_from;
    jacobian.middleCols<3>(3 * constraint.to) = at.J_to;
    omega += jacobian.transpose() * constraint.information * jacobian;
  }
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(3 * kNodes, 3 * kNodes);
  constexpr Eigen::Index kFree = 3 * (kNodes - 1);
  covariance.bottomRightCorner<kFree, kFree>() = omega.bottomRightCorner<kFree, kFree>().inverse();
  return covariance;
}

TEST(MarginalsLaws, AreBlocksOfTheInverse) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const PoseGraph graph = solvedWalk(random);
    const Marginals marginals(graph, noKernels());
    ASSERT_TRUE(marginals.isValid());
    const Eigen::MatrixXd dense = denseCovariance(graph);
    for (NodeId node = 0; node < kNodes; ++node) {
      const Eigen::Matrix3d block = dense.block<3, 3>(3 * node, 3 * node);
      EXPECT_LT((marginals.covariance(node) - block).norm(), 1e-9 * (1.0 + block.norm()));
    }
    const auto joint = marginals.jointCovariance(4, 23);
    EXPECT_LT((joint.topRightCorner<3, 3>() - dense.block<3, 3>(12, 69)).norm(), 1e-9);
    EXPECT_LT((joint.bottomRightCorner<3, 3>() - dense.block<3, 3>(69, 69)).norm(), 1e-9);
  }
}

/// Where two poses lie relative to each other does not depend on which node is held.
TEST(MarginalsLaws, RelativeCovarianceKnowsNoAnchor) {
  std::mt19937_64 random(5);
  PoseGraph graph = solvedWalk(random);
  const Eigen::Matrix3d held_at_start = Marginals(graph, noKernels()).relativeCovariance(6, 19);
  graph.held = {29};
  const Eigen::Matrix3d held_at_end = Marginals(graph, noKernels()).relativeCovariance(6, 19);
  EXPECT_LT((held_at_start - held_at_end).norm(), 1e-9);
}

TEST(MarginalsLaws, OfAChainIsTheMeasurementsCovariance) {
  std::mt19937_64 random(6);
  PoseGraph graph = test::randomWalk({2, 0, 0.0, 0.0}, random).graph;
  const Constraint& step = graph.constraints.front();
  // From the axes of the measurement, in which information is given, to those of node 0.
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = step.T_from_to.rotation();
  const Eigen::Matrix3d expected = turn * step.information.inverse() * turn.transpose();
  EXPECT_LT((Marginals(graph).relativeCovariance(0, 1) - expected).norm(), 1e-9);
}

TEST(MarginalsLaws, WhatIsNotDeterminedHasNone) {
  std::mt19937_64 random(6);
  PoseGraph graph = test::randomWalk({3, 0, 0.0, 0.0}, random).graph;
  graph.constraints[0].information.setZero();
  EXPECT_FALSE(Marginals(graph).isValid());
}

}  // namespace
}  // namespace omega_slam::graph

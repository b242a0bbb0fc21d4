#include "omega_slam/graph/selected_inverse.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "omega_slam/graph/descent.h"
#include "support/graphs.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

constexpr NodeId kNodes = 60;

/// Omega at a walk's poses, every second loop with no weight: its elements are there, as zeros.
InformationForm formOf(const PoseGraph& graph) {
  KernelConfig kernels;
  kernels.loop.kind = KernelKind::kGraduated;
  Weighing weighing(kernels, graph);
  std::vector<double> weights(weighing.graduated().size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = static_cast<double>(i % 2);
  }
  weighing.setStage(weights);
  InformationForm form(kNodes, graph.constraints, {0});
  fillForm(graph, weighing, form);
  return form;
}

Eigen::MatrixXd wholeOf(const InformationForm& form) {
  const Eigen::MatrixXd lower(form.omega());
  return lower.selfadjointView<Eigen::Lower>();
}

TEST(SelectedInverseLaws, IsTheInverseWhereTheGraphHasConstraints) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const PoseGraph graph = test::randomWalk({kNodes, 40, 0.05, 0.1}, random).graph;
    const InformationForm form = formOf(graph);
    SparseCholesky cholesky(form);
    ASSERT_TRUE(cholesky.factorize(form));
    const SelectedInverse inverse(cholesky.columns());
    const Eigen::MatrixXd dense = wholeOf(form).inverse();
    const auto expectBlock = [&](NodeId a, NodeId b) {
      const Eigen::Matrix3d block = dense.block<3, 3>(3 * a, 3 * b);
      EXPECT_LT((inverse.block(a, b) - block).norm(), 1e-9 * dense.norm()) << a << " " << b;
    };
    for (NodeId node = 0; node < kNodes; ++node) {
      expectBlock(node, node);
    }
    for (const Constraint& constraint : graph.constraints) {
      expectBlock(constraint.from, constraint.to);
      expectBlock(constraint.to, constraint.from);
    }
  }
}

TEST(SelectedInverseLaws, FactorsColumnsMultiplyToOmega) {
  std::mt19937_64 random(7);
  const InformationForm form = formOf(test::randomWalk({kNodes, 40, 0.05, 0.1}, random).graph);
  SparseCholesky cholesky(form);
  ASSERT_TRUE(cholesky.factorize(form));
  const FactorColumns columns = cholesky.columns();
  constexpr Eigen::Index kRows = 3 * kNodes;
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(kRows, kRows);
  Eigen::MatrixXd permutation = Eigen::MatrixXd::Zero(kRows, kRows);
  for (std::size_t j = 0; j < kRows; ++j) {
    permutation(static_cast<Eigen::Index>(j), columns.order[j]) = 1.0;
    ASSERT_EQ(columns.rows[static_cast<std::size_t>(columns.starts[j])], static_cast<int>(j));
    for (int k = columns.starts[j]; k < columns.starts[j + 1]; ++k) {
      const auto i = static_cast<std::size_t>(k);
      factor(columns.rows[i], static_cast<Eigen::Index>(j)) = columns.values[i];
    }
  }
  const Eigen::MatrixXd omega = wholeOf(form);
  const Eigen::MatrixXd product =
      permutation.transpose() * factor * factor.transpose() * permutation;
  EXPECT_LT((product - omega).norm(), 1e-9 * omega.norm());
}

}  // namespace
}  // namespace omega_slam::graph

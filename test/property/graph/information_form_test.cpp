#include "omega_slam/graph/information_form.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "omega_slam/graph/sparse_cholesky.h"
#include "support/graphs.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

/// The same sums, made without any sparsity.
struct DenseForm {
  Eigen::MatrixXd omega;
  Eigen::VectorXd xi;
};

DenseForm denseForm(const PoseGraph& graph, const std::vector<NodeId>& held) {
  const auto rows = static_cast<Eigen::Index>(3 * graph.poses.size());
  DenseForm form{Eigen::MatrixXd::Zero(rows, rows), Eigen::VectorXd::Zero(rows)};
  for (const Constraint& constraint : graph.constraints) {
    const LinearizedConstraint at = linearize(constraint, graph);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, rows);
    jacobian.middleCols<3>(3 * static_cast<Eigen::Index>(constraint.from)) = at.J_from;
    jacobian.middleCols<3>(3 * static_cast<Eigen::Index>(constraint.to)) = at.J_to;
    form.omega += jacobian.transpose() * constraint.information * jacobian;
    form.xi -= jacobian.transpose() * constraint.information * at.error;
  }
  for (const NodeId node : held) {
    const auto row = 3 * static_cast<Eigen::Index>(node);
    form.omega.middleRows<3>(row).setZero();
    form.omega.middleCols<3>(row).setZero();
    form.omega.block<3, 3>(row, row).setIdentity();
    form.xi.segment<3>(row).setZero();
  }
  return form;
}

void fill(InformationForm& form, const PoseGraph& graph) {
  form.clear();
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    form.add(k, linearize(graph.constraints[k], graph), graph.constraints[k].information);
  }
}

TEST(InformationFormLaws, TheSparseSumsAreTheDenseOnes) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const PoseGraph graph = test::randomWalk({25, 20, 0.1, 0.3}, random).graph;
    for (const std::vector<NodeId>& held :
         {std::vector<NodeId>{}, std::vector<NodeId>{0}, std::vector<NodeId>{4, 24}}) {
      InformationForm form(graph.poses.size(), graph.constraints, held);
      fill(form, graph);
      fill(form, graph);  // what was there before is forgotten
      const DenseForm dense = denseForm(graph, held);
      const Eigen::MatrixXd lower = Eigen::MatrixXd(form.omega()).triangularView<Eigen::Lower>();
      EXPECT_TRUE(
          lower.isApprox(Eigen::MatrixXd(dense.omega.triangularView<Eigen::Lower>()), 1e-12));
      EXPECT_TRUE(form.xi().isApprox(dense.xi, 1e-12));
    }
  }
}

TEST(InformationFormLaws, DampingGrowsTheDiagonalAlone) {
  std::mt19937_64 random(2);
  const PoseGraph graph = test::randomWalk({10, 5, 0.1, 0.3}, random).graph;
  InformationForm form(graph.poses.size(), graph.constraints, {0});
  fill(form, graph);
  const Eigen::MatrixXd before(form.omega());
  form.damp(0.5);
  form.addDiagonal(3, 2, 7.0);
  Eigen::MatrixXd expected = before;
  expected.diagonal() *= 1.5;
  expected(11, 11) += 7.0;
  EXPECT_TRUE(Eigen::MatrixXd(form.omega()).isApprox(expected, 1e-12));
}

TEST(SparseCholeskyLaws, SolvesAsADenseFactorisationDoes) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const PoseGraph graph = test::randomWalk({60, 60, 0.1, 0.3}, random).graph;
    InformationForm form(graph.poses.size(), graph.constraints, {0});
    fill(form, graph);
    SparseCholesky cholesky(form);
    ASSERT_TRUE(cholesky.factorize(form));
    const DenseForm dense = denseForm(graph, {0});
    const Eigen::VectorXd mu = dense.omega.ldlt().solve(dense.xi);
    EXPECT_TRUE(cholesky.solve(form.xi()).isApprox(mu, 1e-8));
    EXPECT_GE(cholesky.factorSize(), 3.0 * static_cast<double>(graph.poses.size()));
  }
}

TEST(SparseCholeskyLaws, ASingularMatrixIsAnAnswer) {
  std::mt19937_64 random(9);
  const PoseGraph graph = test::randomWalk({10, 5, 0.1, 0.3}, random).graph;
  InformationForm form(graph.poses.size(), graph.constraints, {});
  SparseCholesky cholesky(form);
  EXPECT_FALSE(cholesky.factorize(form));  // all zero
}

}  // namespace
}  // namespace omega_slam::graph

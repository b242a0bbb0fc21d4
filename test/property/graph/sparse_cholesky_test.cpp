#include "omega_slam/graph/sparse_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <utility>
#include <vector>

#include "omega_slam/graph/dense_elimination.h"
#include "omega_slam/graph/elimination_plan.h"
#include "support/graphs.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

using Ties = std::vector<std::pair<NodeId, NodeId>>;

MatrixXd randomMatrix(Index rows, Index columns, std::mt19937_64& random) {
  std::uniform_real_distribution<double> element(-1.0, 1.0);
  return MatrixXd::NullaryExpr(rows, columns, [&] { return element(random); });
}

/// Shapes whose elimination trees are unlike: a path, a root with leaves, many parts, a dense one.
std::vector<std::pair<NodeId, Ties>> shapes(std::mt19937_64& random) {
  Ties path, star, parts, dense, grid, scattered;
  for (NodeId node = 1; node < 40; ++node) {
    path.emplace_back(node - 1, node);
    star.emplace_back(node, 0);
    if (node % 4 != 0) {
      parts.emplace_back(node, node - 1);
    }
    for (NodeId other = 0; other < node && node < 12; ++other) {
      dense.emplace_back(other, node);
    }
  }
  for (NodeId node = 0; node < 400; ++node) {
    if (node % 20 != 0) {
      grid.emplace_back(node, node - 1);
    }
    if (node >= 20) {
      grid.emplace_back(node - 20, node);
    }
  }
  std::uniform_int_distribution<NodeId> any(0, 99);
  for (int k = 0; k < 150; ++k) {
    const NodeId a = any(random);
    scattered.emplace_back(a, (a + 1 + any(random) % 99) % 100);
  }
  return {{1, {}}, {40, path}, {40, star}, {40, parts}, {12, dense}, {400, grid}, {100, scattered}};
}

/// Positive definite, with blocks at the ties.
InformationForm randomForm(NodeId nodes, const Ties& ties, std::mt19937_64& random) {
  std::vector<Constraint> constraints(ties.size());
  for (std::size_t k = 0; k < ties.size(); ++k) {
    constraints[k].from = ties[k].first;
    constraints[k].to = ties[k].second;
  }
  InformationForm form(nodes, constraints, {});
  for (std::size_t k = 0; k < ties.size(); ++k) {
    const LinearizedConstraint at{randomMatrix(3, 1, random), randomMatrix(3, 3, random),
                                  randomMatrix(3, 3, random)};
    form.add(k, at, test::randomInformation(random));
  }
  for (NodeId node = 0; node < nodes; ++node) {
    for (int axis = 0; axis < 3; ++axis) {
      form.addDiagonal(node, axis, 1.0);
    }
  }
  return form;
}

MatrixXd wholeOf(const InformationForm& form) {
  return MatrixXd(form.omega()).selfadjointView<Eigen::Lower>();
}

TEST(SparseCholeskyLaws, SolvesFormsOfAnyShape) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (const auto& [nodes, ties] : shapes(random)) {
      SCOPED_TRACE(nodes);
      SCOPED_TRACE(ties.size());
      const InformationForm form = randomForm(nodes, ties, random);
      SparseCholesky cholesky(form);
      for (int times = 0; times < 2; ++times) {  // nothing is left of the first time
        ASSERT_TRUE(cholesky.factorize(form));
        const VectorXd right = randomMatrix(3 * nodes, 1, random);
        EXPECT_TRUE((wholeOf(form) * cholesky.solve(right)).isApprox(right, 1e-9));
      }
    }
  }
}

TEST(EliminationPlanLaws, EveryNodeHasAPlaceInOnePanel) {
  std::mt19937_64 random(3);
  for (const auto& [nodes, ties] : shapes(random)) {
    SCOPED_TRACE(nodes);
    const EliminationPlan plan(randomForm(nodes, ties, random).blocks());
    std::vector<int> places(plan.place.data(), plan.place.data() + plan.place.size());
    std::sort(places.begin(), places.end());
    int next = 0;
    for (const Panel& panel : plan.panels) {
      EXPECT_EQ(panel.first, next);
      for (; next < panel.first + panel.count; ++next) {
        EXPECT_EQ(places[static_cast<std::size_t>(next)], next);
      }
      EXPECT_TRUE(std::is_sorted(panel.rows.begin(), panel.rows.end()));
      EXPECT_EQ(panel.parent == -1, panel.rows.empty());
      for (int row = panel.count; row < panel.height(); ++row) {
        const Panel& parent = plan.panels[static_cast<std::size_t>(panel.parent)];
        const int there = panel.in_parent[static_cast<std::size_t>(row - panel.count)];
        EXPECT_EQ(parent.nodeOf(there), panel.nodeOf(row));
        EXPECT_EQ(panel.rowOf(panel.nodeOf(row)), row);
      }
    }
    EXPECT_EQ(next, static_cast<int>(nodes));
  }
}

TEST(EliminationPlanLaws, APathAndAStarHardlyFillTheFactor) {
  std::mt19937_64 random(4);
  const auto all = shapes(random);
  for (const std::size_t shape : {1u, 2u}) {
    const auto& [nodes, ties] = all[shape];
    const EliminationPlan plan(randomForm(nodes, ties, random).blocks());
    EXPECT_LE(plan.elements, 2 * 9 * static_cast<Index>(nodes + ties.size()));
  }
}

/// [A; B] with A positive definite.
MatrixXd randomPanel(Index height, Index width, std::mt19937_64& random) {
  MatrixXd panel = randomMatrix(height, width, random);
  panel.topRows(width) = MatrixXd(panel.topRows(width) * panel.topRows(width).transpose());
  panel.diagonal().array() += 1.0;
  return panel;
}

TEST(DenseEliminationLaws, AgreeWithTheTextbook) {
  std::mt19937_64 random(5);
  for (const Index width : {3, 6, 9, 21}) {
    for (const Index below : {0, 3, 6, 15, 30}) {
      SCOPED_TRACE(width);
      SCOPED_TRACE(below);
      const MatrixXd before = randomPanel(width + below, width, random);
      MatrixXd panel = before;
      ASSERT_TRUE(eliminate(PanelMap(panel.data(), panel.rows(), panel.cols())));
      const MatrixXd own = before.topRows(width).llt().matrixL();
      const MatrixXd rest = before.bottomRows(below) * own.inverse().transpose();
      EXPECT_TRUE(MatrixXd(panel.topRows(width).triangularView<Eigen::Lower>()).isApprox(own));
      EXPECT_LE((panel.bottomRows(below) - rest).norm(), 1e-9 * (1.0 + rest.norm()));
      const ConstPanelMap done(panel.data(), panel.rows(), panel.cols());
      const MatrixXd difference = leftBy(done) + rest * rest.transpose();
      EXPECT_LE(MatrixXd(difference.triangularView<Eigen::Lower>()).norm(),
                1e-9 * (1.0 + rest.squaredNorm()));
      const VectorXd x = randomMatrix(width + below, 1, random);
      VectorXd forward = x;
      substituteForward(done, forward);
      const VectorXd a = own.triangularView<Eigen::Lower>().solve(x.head(width));
      EXPECT_TRUE(forward.head(width).isApprox(a, 1e-9));
      EXPECT_LE((forward.tail(below) - x.tail(below) + rest * a).norm(), 1e-9 * (1.0 + a.norm()));
      VectorXd backward = x;
      substituteBackward(done, backward);
      EXPECT_TRUE((own.transpose() * backward.head(width))
                      .isApprox(x.head(width) - rest.transpose() * x.tail(below), 1e-9));
    }
  }
}

TEST(DenseEliminationLaws, WhatIsNotPositiveDefiniteIsAnAnswer) {
  std::mt19937_64 random(6);
  for (const Index bad : {0, 4, 8}) {
    MatrixXd panel = randomPanel(15, 9, random);
    panel(bad, bad) = -1.0;
    EXPECT_FALSE(eliminate(PanelMap(panel.data(), panel.rows(), panel.cols())));
  }
}

}  // namespace
}  // namespace omega_slam::graph

// The equations of the paper "Graph-based Simultaneous Localization and Mapping on the TurtleBot
// platform", section 6.1, are the special case of ours.

#include <gtest/gtest.h>

#include <random>

#include "omega_slam/graph/information_form.h"
#include "omega_slam/graph/solver.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

using geometry::Pose2;

Constraint difference(NodeId from, NodeId to, double dx, double dy) {
  Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.T_from_to = {dx, dy, 0.0};
  return constraint;
}

SolverConfig linear() {
  SolverConfig config;
  config.method = SolverMethod::kLinear;
  return config;
}

/// Equations 4 and 5, written down as they are printed.
TEST(PaperEquations, AreWhatOneConstraintAdds) {
  const Eigen::Vector3d p_i(1.0, 2.0, 0.3);
  const Eigen::Vector3d p_j(4.0, -1.0, 0.8);
  Constraint constraint = difference(0, 1, 3.0, -3.0);
  constraint.T_from_to.theta = 0.5;
  InformationForm form(2, {constraint}, {});
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  form.add(0, paperConstraint(constraint, {}, {}), one);

  Eigen::Matrix<double, 6, 6> omega;
  omega << one, -one, -one, one;
  Eigen::Matrix<double, 6, 1> xi;
  xi << p_i - p_j, p_j - p_i;
  const Eigen::MatrixXd lower = Eigen::MatrixXd(form.omega()).triangularView<Eigen::Lower>();
  EXPECT_TRUE(lower.isApprox(Eigen::MatrixXd(omega.triangularView<Eigen::Lower>())));
  EXPECT_TRUE(form.xi().isApprox(xi));
}

TEST(PaperEquations, OfAChainGiveTheChain) {
  PoseGraph graph;
  graph.poses = {{10.0, 20.0, 0.0}, {-3.0, 0.0, 0.0}, {0.0, 5.0, 0.0}};
  graph.constraints = {difference(0, 1, 1.0, 0.0), difference(1, 2, 0.5, 2.0)};
  ASSERT_EQ(solve(graph, linear()).status, SolveStatus::kConverged);
  EXPECT_TRUE(graph.poses[0].vector().isApprox(Eigen::Vector3d(10, 20, 0)));
  EXPECT_TRUE(graph.poses[1].vector().isApprox(Eigen::Vector3d(11, 20, 0)));
  EXPECT_TRUE(graph.poses[2].vector().isApprox(Eigen::Vector3d(11.5, 22, 0)));
}

TEST(PaperEquations, SpreadALoopsErrorEvenly) {
  PoseGraph graph;
  graph.poses.resize(3);
  graph.constraints = {difference(0, 1, 1.0, 0.0), difference(1, 2, 1.0, 0.0),
                       difference(0, 2, 1.7, 0.0)};
  ASSERT_EQ(solve(graph, linear()).status, SolveStatus::kConverged);
  EXPECT_NEAR(graph.poses[1].x, 0.9, 1e-9);
  EXPECT_NEAR(graph.poses[2].x, 1.8, 1e-9);
}

/// On SE(2), with headings that are all but known, the general solver finds the paper's solution.
TEST(PaperEquations, AreTheSpecialCaseOfTheGeneralSolver) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0.0, 0.2);
    constexpr NodeId kNodes = 12;
    PoseGraph graph;
    std::vector<Eigen::Vector2d> truth;
    for (NodeId i = 0; i < kNodes; ++i) {
      truth.emplace_back(1.0 * i, 0.1 * i * i);
      graph.poses.push_back({0.9 * i, 0.0, 0.0});
    }
    const auto tie = [&](NodeId i, NodeId j) {
      Constraint constraint = difference(i, j, truth[j].x() - truth[i].x() + noise(random),
                                         truth[j].y() - truth[i].y() + noise(random));
      constraint.information.diagonal()[2] = 1e12;
      graph.constraints.push_back(constraint);
    };
    for (NodeId i = 0; i + 1 < kNodes; ++i) {
      tie(i, i + 1);
    }
    tie(0, 5);
    tie(3, 11);
    PoseGraph by_paper = graph;
    ASSERT_EQ(solve(by_paper, linear()).status, SolveStatus::kConverged);
    ASSERT_EQ(solve(graph).status, SolveStatus::kConverged);
    for (NodeId i = 0; i < kNodes; ++i) {
      EXPECT_NEAR(graph.poses[i].x, by_paper.poses[i].x, 1e-6);
      EXPECT_NEAR(graph.poses[i].y, by_paper.poses[i].y, 1e-6);
    }
  }
}

}  // namespace
}  // namespace omega_slam::graph

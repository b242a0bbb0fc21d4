#include "omega_slam/graph/solver.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/graph/linearization.h"
#include "support/graphs.h"
#include "support/poses.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

using geometry::Pose2;

using test::GraphProblem;
using test::measure;

/// The true model has no kernels.
SolverConfig plain() {
  SolverConfig config;
  config.kernels.loop.kind = KernelKind::kNone;
  return config;
}

GraphProblem randomWalk(double noise, double disturbance, std::mt19937_64& random) {
  return test::randomWalk({40, 15, noise, disturbance}, random);
}

TEST(SolverLaws, JacobiansAgreeWithNumericOnes) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 100; ++i) {
      const std::vector<Pose2> poses = {test::randomPose(5.0, 3.2, random),
                                        test::randomPose(5.0, 3.2, random)};
      const Constraint constraint = measure(poses, 0, 1, 0.5, random);
      const auto at = linearize(constraint, poses[0], poses[1]);
      constexpr double kStep = 1e-6;
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
        const auto moved = [&](const Pose2& pose, double sign) {
          return Pose2::fromVector(pose.vector() + sign * step);
        };
        const Eigen::Vector3d by_from =
            (linearize(constraint, moved(poses[0], 1.0), poses[1]).error -
             linearize(constraint, moved(poses[0], -1.0), poses[1]).error) /
            (2.0 * kStep);
        const Eigen::Vector3d by_to =
            (linearize(constraint, poses[0], moved(poses[1], 1.0)).error -
             linearize(constraint, poses[0], moved(poses[1], -1.0)).error) /
            (2.0 * kStep);
        EXPECT_LT((by_from - at.J_from.col(axis)).norm(), 1e-6);
        EXPECT_LT((by_to - at.J_to.col(axis)).norm(), 1e-6);
      }
    }
  }
}

TEST(SolverLaws, WithoutNoiseTheTruthIsFound) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    GraphProblem problem = randomWalk(0.0, 0.3, random);
    const SolveReport report = solve(problem.graph, plain());
    EXPECT_EQ(report.status, SolveStatus::kConverged);
    EXPECT_LT(report.chi_square, 1e-9);
    for (std::size_t i = 0; i < problem.truth.size(); ++i) {
      const auto gap = test::gapBetween(problem.graph.poses[i], problem.truth[i]);
      EXPECT_LT(gap.translation, 1e-6);
      EXPECT_LT(gap.rotation, 1e-6);
    }
  }
}

TEST(SolverLaws, CostFallsAndTheSolutionIsStationary) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    GraphProblem problem = randomWalk(0.05, 0.2, random);
    SolverConfig config = plain();
    config.limits.relative_gain = 1e-12;
    const SolveReport report = solve(problem.graph, config);
    EXPECT_LT(report.chi_square, report.initial_chi_square);
    EXPECT_NEAR(report.chi_square, chiSquare(problem.graph), 1e-9);
    for (int i = 0; i < 50; ++i) {
      PoseGraph moved = problem.graph;
      const std::size_t node = 1 + random() % 39;
      moved.poses[node] = moved.poses[node] * test::randomPose(1e-3, 1e-3, random);
      EXPECT_GE(chiSquare(moved), report.chi_square - 1e-9);
    }
  }
}

TEST(SolverLaws, AllMethodsFindTheSameMinimum) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    GraphProblem problem = randomWalk(0.05, 0.2, random);
    PoseGraph damped = problem.graph;
    SolverConfig config = plain();
    config.limits = {100, 1e-12};
    const double chi_square = solve(problem.graph, config).chi_square;
    config.method = SolverMethod::kLevenbergMarquardt;
    const SolveReport report = solve(damped, config);
    EXPECT_EQ(report.status, SolveStatus::kConverged);
    EXPECT_NEAR(report.chi_square, chi_square, 1e-6 * chi_square);
  }
}

TEST(SolverLaws, ASolverThatIsUsedAgainIsAsGoodAsNew) {
  std::mt19937_64 random(3);
  GraphSolver solver(plain());
  GraphProblem problem = randomWalk(0.05, 0.2, random);
  for (int i = 0; i < 10; ++i) {
    if (i % 2 == 1) {  // now and then the structure changes
      problem.graph.constraints.push_back(measure(problem.truth, 3, 30, 0.05, random));
    }
    problem.graph.poses[5] = problem.graph.poses[5] * test::randomPose(0.1, 0.1, random);
    PoseGraph fresh = problem.graph;
    EXPECT_EQ(solver.solve(problem.graph).chi_square, solve(fresh, plain()).chi_square);
  }
}

TEST(SolverLaws, HeldNodesStayWhereTheyAre) {
  std::mt19937_64 random(4);
  GraphProblem problem = randomWalk(0.05, 0.2, random);
  PoseGraph& graph = problem.graph;
  graph.held = {7, 21};
  const PoseGraph before = graph;
  EXPECT_EQ(solve(graph, plain()).status, SolveStatus::kConverged);
  for (std::size_t i = 0; i < graph.poses.size(); ++i) {
    const bool stays = graph.poses[i].vector() == before.poses[i].vector();
    EXPECT_EQ(stays, i == 7 || i == 21) << i;
  }
  EXPECT_LT(chiSquare(graph), chiSquare(before));
}

TEST(SolverLaws, PointsWithoutHeadingAreFound) {
  std::mt19937_64 random(5);
  GraphProblem problem = randomWalk(0.0, 0.1, random);
  PoseGraph& graph = problem.graph;
  const Pose2 landmark{2.0, 3.0, 0.0};
  graph.poses.push_back({1.0, 1.0, 0.0});
  graph.points = {40};
  for (const NodeId seer : {NodeId{3}, NodeId{17}}) {
    Constraint sight;
    sight.from = seer;
    sight.to = 40;
    sight.T_from_to = relativePose(problem.truth[seer], landmark);
    sight.T_from_to.theta = 0.0;
    sight.information.diagonal() << 100.0, 100.0, 0.0;
    sight.kind = ConstraintKind::kLandmark;
    graph.constraints.push_back(sight);
  }
  EXPECT_EQ(solve(graph, plain()).status, SolveStatus::kConverged);
  EXPECT_LT(test::gapBetween(graph.poses[40], landmark).translation, 1e-6);
}

TEST(SolverLaws, OrderOfConstraintsDoesNotMatter) {
  std::mt19937_64 random(9);
  GraphProblem problem = randomWalk(0.05, 0.1, random);
  PoseGraph shuffled = problem.graph;
  std::shuffle(shuffled.constraints.begin(), shuffled.constraints.end(), random);
  solve(problem.graph, plain());
  solve(shuffled, plain());
  for (std::size_t i = 0; i < problem.truth.size(); ++i) {
    EXPECT_LT(test::gapBetween(problem.graph.poses[i], shuffled.poses[i]).translation, 1e-5);
  }
}

TEST(SolverLaws, WhereTheGraphLiesDoesNotMatter) {
  std::mt19937_64 random(11);
  GraphProblem problem = randomWalk(0.05, 0.1, random);
  const Pose2 T_other_map{30.0, -5.0, 2.0};
  PoseGraph moved = problem.graph;
  for (Pose2& pose : moved.poses) {
    pose = T_other_map * pose;
  }
  SolverConfig config = plain();
  config.limits.relative_gain = 1e-12;
  const auto here = solve(problem.graph, config);
  const auto there = solve(moved, config);
  EXPECT_NEAR(here.chi_square, there.chi_square, 1e-6 * here.chi_square);
  for (std::size_t i = 0; i < problem.truth.size(); ++i) {
    const auto gap = test::gapBetween(T_other_map * problem.graph.poses[i], moved.poses[i]);
    EXPECT_LT(gap.translation, 1e-5);
  }
}

TEST(SolverLaws, NewLeafIsPlacedWhereTheWholeSolvePutsIt) {
  std::mt19937_64 random(13);
  GraphProblem problem = randomWalk(0.0, 0.0, random);
  PoseGraph& graph = problem.graph;
  const std::vector<Constraint> ties = {measure(problem.truth, 38, 39, 0.1, random),
                                        measure(problem.truth, 38, 39, 0.1, random)};
  graph.constraints.clear();
  for (NodeId i = 0; i < 38; ++i) {
    graph.constraints.push_back(measure(problem.truth, i, i + 1, 0.0, random));
  }
  graph.poses[39] = graph.poses[38];
  graph.poses[39] = relaxNode(graph, 39, ties);
  graph.constraints.insert(graph.constraints.end(), ties.begin(), ties.end());
  const Pose2 placed = graph.poses[39];
  SolverConfig config = plain();
  config.limits.relative_gain = 1e-12;
  solve(graph, config);
  EXPECT_LT(test::gapBetween(placed, graph.poses[39]).translation, 1e-5);
}

/// How far a false loop bends a graph under a kernel [m].
double bendOf(const PoseGraph& graph, const Constraint& lie, RobustKernel kernel) {
  PoseGraph clean = graph;
  PoseGraph bent = graph;
  bent.constraints.push_back(lie);
  SolverConfig config = plain();
  config.kernels.loop = kernel;
  config.limits.max_iterations = 100;
  solve(clean, plain());
  solve(bent, config);
  double largest = 0.0;
  for (std::size_t i = 0; i < graph.poses.size(); ++i) {
    largest = std::max(largest, test::gapBetween(bent.poses[i], clean.poses[i]).translation);
  }
  return largest;
}

TEST(SolverLaws, KernelKeepsAFalseLoopFromBendingTheGraph) {
  std::mt19937_64 random(17);
  GraphProblem problem = randomWalk(0.01, 0.0, random);
  Constraint lie = measure(problem.truth, 2, 35, 0.0, random);
  lie.T_from_to = lie.T_from_to * Pose2{3.0, 2.0, 1.0};
  lie.kind = ConstraintKind::kLoop;
  const auto bend = [&](RobustKernel kernel) { return bendOf(problem.graph, lie, kernel); };
  const double unguarded = bend({KernelKind::kNone, 1.0});
  EXPECT_LT(bend({KernelKind::kHuber, 1.0}), 0.3 * unguarded);
  EXPECT_LT(bend({KernelKind::kCauchy, 1.0}), 0.1 * unguarded);
  EXPECT_LT(bend({KernelKind::kScaling, 1.0}), 0.1 * unguarded);
  EXPECT_LT(bend({KernelKind::kGraduated, 3.4}), 1e-4 * unguarded);
}

}  // namespace
}  // namespace omega_slam::graph

#include "omega_slam/graph/solver.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "support/poses.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

using geometry::Pose2;

Eigen::Matrix3d randomInformation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::Matrix3d a;
  for (int i = 0; i < 9; ++i) {
    a(i / 3, i % 3) = normal(random);
  }
  return 20.0 * (a * a.transpose() + Eigen::Matrix3d::Identity());
}

Constraint measure(const std::vector<Pose2>& truth, NodeId from, NodeId to, double noise,
                   std::mt19937_64& random) {
  Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.T_from_to = relativePose(truth[from], truth[to]) *
                         (noise > 0.0 ? test::randomPose(noise, noise, random) : Pose2{});
  constraint.information = randomInformation(random);
  return constraint;
}

struct Problem {
  std::vector<Pose2> truth;
  PoseGraph graph;
};

/// A walk of 40 poses with loops; the first guess is the truth, disturbed.
Problem randomWalk(double noise, double disturbance, std::mt19937_64& random) {
  Problem problem;
  problem.truth.push_back({});
  for (int i = 1; i < 40; ++i) {
    problem.truth.push_back(problem.truth.back() * Pose2{0.5, 0.0, 0.0} *
                            test::randomPose(0.1, 0.4, random));
  }
  for (NodeId i = 0; i + 1 < 40; ++i) {
    problem.graph.constraints.push_back(measure(problem.truth, i, i + 1, noise, random));
  }
  for (int i = 0; i < 15; ++i) {
    const auto from = static_cast<NodeId>(random() % 40);
    const auto to = static_cast<NodeId>(random() % 40);
    if (from != to) {
      problem.graph.constraints.push_back(measure(problem.truth, from, to, noise, random));
    }
  }
  problem.graph.poses = problem.truth;
  for (std::size_t i = 1; i < 40; ++i) {
    problem.graph.poses[i] =
        problem.graph.poses[i] * test::randomPose(disturbance, disturbance, random);
  }
  return problem;
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
    Problem problem = randomWalk(0.0, 0.3, random);
    const SolveReport report = solve(problem.graph);
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
    Problem problem = randomWalk(0.05, 0.2, random);
    SolverConfig config;
    config.relative_gain = 1e-12;
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

TEST(SolverLaws, OrderOfConstraintsDoesNotMatter) {
  std::mt19937_64 random(9);
  Problem problem = randomWalk(0.05, 0.1, random);
  PoseGraph shuffled = problem.graph;
  std::shuffle(shuffled.constraints.begin(), shuffled.constraints.end(), random);
  solve(problem.graph);
  solve(shuffled);
  for (std::size_t i = 0; i < problem.truth.size(); ++i) {
    EXPECT_LT(test::gapBetween(problem.graph.poses[i], shuffled.poses[i]).translation, 1e-5);
  }
}

TEST(SolverLaws, WhereTheGraphLiesDoesNotMatter) {
  std::mt19937_64 random(11);
  Problem problem = randomWalk(0.05, 0.1, random);
  const Pose2 T_other_map{30.0, -5.0, 2.0};
  PoseGraph moved = problem.graph;
  for (Pose2& pose : moved.poses) {
    pose = T_other_map * pose;
  }
  SolverConfig config;
  config.relative_gain = 1e-12;
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
  Problem problem = randomWalk(0.0, 0.0, random);
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
  SolverConfig config;
  config.relative_gain = 1e-12;
  solve(graph, config);
  EXPECT_LT(test::gapBetween(placed, graph.poses[39]).translation, 1e-5);
}

TEST(SolverLaws, KernelKeepsAFalseLoopFromBendingTheGraph) {
  std::mt19937_64 random(17);
  Problem problem = randomWalk(0.01, 0.0, random);
  Constraint lie = measure(problem.truth, 2, 35, 0.0, random);
  lie.T_from_to = lie.T_from_to * Pose2{3.0, 2.0, 1.0};
  lie.kind = ConstraintKind::kLoop;
  problem.graph.constraints.push_back(lie);
  const auto worst = [&](double kernel) {
    PoseGraph graph = problem.graph;
    SolverConfig config;
    config.loop_kernel = kernel;
    config.max_iterations = 100;
    solve(graph, config);
    double largest = 0.0;
    for (std::size_t i = 0; i < graph.poses.size(); ++i) {
      largest = std::max(largest, test::gapBetween(graph.poses[i], problem.truth[i]).translation);
    }
    return largest;
  };
  EXPECT_LT(worst(1.0), 0.3 * worst(0.0));
}

}  // namespace
}  // namespace omega_slam::graph

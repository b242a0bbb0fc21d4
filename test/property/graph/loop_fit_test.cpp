#include "omega_slam/graph/loop_fit.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <utility>

#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/loop_consistency.h"
#include "omega_slam/graph/loop_examination.h"
#include "omega_slam/graph/marginals.h"
#include "omega_slam/graph/solver.h"
#include "omega_slam/graph/topology.h"
#include "support/false_loops.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

KernelConfig noKernels() {
  KernelConfig kernels;
  kernels.loop.kind = KernelKind::kNone;
  return kernels;
}

void solvePlainly(PoseGraph& graph) {
  SolverConfig config;
  config.kernels = noKernels();
  config.limits = {50, 1e-12};
  ASSERT_EQ(solve(graph, config).status, SolveStatus::kConverged);
}

std::vector<LoopFit> examineAll(const PoseGraph& graph, const std::vector<std::size_t>& loops) {
  GraphSystem system;
  system.prepare(graph, spanningForest(graph).roots);
  return examine(graph, Weighing(noKernels(), graph), system, loops).value();
}

std::vector<std::size_t> loopsOf(const PoseGraph& graph) {
  std::vector<std::size_t> loops;
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    if (graph.constraints[k].kind == ConstraintKind::kLoop) {
      loops.push_back(k);
    }
  }
  return loops;
}

/// Little noise, so that the problem is as good as linear.
TEST(LoopFitLaws, OfACountedLoopIsTheFitToTheGraphWithoutIt) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    PoseGraph graph = test::drivenRounds({4, 2, 0.001, 1.0}, random).graph;
    solvePlainly(graph);
    const auto loops = loopsOf(graph);
    const auto fits = examineAll(graph, loops);
    for (const std::size_t i : {std::size_t{0}, std::size_t{7}, loops.size() - 1}) {
      PoseGraph without = graph;
      const Constraint loop = graph.constraints[loops[i]];
      without.constraints.erase(without.constraints.begin() +
                                static_cast<std::ptrdiff_t>(loops[i]));
      solvePlainly(without);
      const Marginals marginals(without, noKernels());
      const LoopFit fit =
          fitOfNewLoop(without, loop, marginals.relativeCovariance(loop.from, loop.to));
      EXPECT_NEAR(fits[i].squared, fit.squared, 0.01 * (1.0 + fit.squared));
      EXPECT_NEAR(fits[i].spread / fit.spread, 1.0, 0.01);
    }
  }
}

TEST(LoopFitLaws, OfRightLoopsIsChiSquareWithThreeDegreesOfFreedom) {
  double sum = 0.0;
  std::size_t count = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937_64 random(seed);
    PoseGraph graph = test::drivenRounds({5, 3, 0.01, 1.0}, random).graph;
    solvePlainly(graph);
    for (const LoopFit& fit : examineAll(graph, loopsOf(graph))) {
      sum += fit.squared;
      ++count;
    }
  }
  EXPECT_NEAR(sum / static_cast<double>(count), 3.0, 0.25);
}

TEST(LoopFitLaws, ChanceDoesNotDependOnTheScaleOfCovariances) {
  std::mt19937_64 random(3);
  PoseGraph graph = test::drivenRounds({5, 2, 0.02, 1.0}, random).graph;
  solvePlainly(graph);
  PoseGraph timid = graph;
  for (Constraint& constraint : timid.constraints) {
    constraint.information *= 0.01;
  }
  const auto loops = loopsOf(graph);
  const auto fits = examineAll(graph, loops);
  const auto timid_fits = examineAll(timid, loops);
  const ErrorSpace space = ErrorSpace::of(graph.poses);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    EXPECT_NEAR(timid_fits[i].squared, 0.01 * fits[i].squared, 1e-6 * (1.0 + fits[i].squared));
    EXPECT_NEAR(chanceOf(timid_fits[i], space) / chanceOf(fits[i], space), 1.0, 1e-4);
  }
}

/// The covariance of a cycle through two loops and two pieces of the drive, carried through turns.
TEST(LoopConsistencyLaws, DisagreementOfRightLoopsIsChiSquareWithThreeDegreesOfFreedom) {
  double sum = 0.0;
  std::size_t count = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937_64 random(seed);
    const PoseGraph graph = test::drivenRounds({3, 2, 0.005, 1.0}, random).graph;
    const OdometryChain chain(graph);
    const auto loops = loopsOf(graph);
    for (const std::size_t apart : {1, 2, 5, 9}) {  // steps, round up to three corners
      sum += *chain.disagreement(graph.constraints[loops[0]], graph.constraints[loops[apart]]);
      ++count;
    }
  }
  EXPECT_NEAR(sum / static_cast<double>(count), 3.0, 0.3);
}

/// The same measurement named backwards, with its covariance carried to the other end.
Constraint backwards(const Constraint& loop) {
  const geometry::Pose2& T = loop.T_from_to;
  Eigen::Matrix3d carry = Eigen::Matrix3d::Identity();
  carry.topLeftCorner<2, 2>() = T.rotation();
  carry(0, 2) = T.y;
  carry(1, 2) = -T.x;
  Constraint reverse = loop;
  std::swap(reverse.from, reverse.to);
  reverse.T_from_to = T.inverse();
  reverse.information = (carry * loop.information.inverse() * carry.transpose()).inverse();
  return reverse;
}

TEST(LoopConsistencyLaws, DirectionOfANameSaysNothing) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const auto problem = test::drivenRounds({4, 2, 0.01, 1.0}, random);
    const OdometryChain chain(problem.graph);
    const Constraint a = test::measure(problem.truth, 3, 20, 0.05, random);
    const Constraint b = test::measure(problem.truth, 5, 23, 0.05, random);
    const double squared = *chain.disagreement(a, b);
    EXPECT_NEAR(*chain.disagreement(a, backwards(b)), squared, 1e-5 * squared);
    EXPECT_NEAR(*chain.disagreement(backwards(a), b), squared, 1e-5 * squared);
  }
}

TEST(LoopConsistencyLaws, DisagreementIsMutual) {
  std::mt19937_64 random(11);
  const PoseGraph graph = test::drivenRounds({4, 3, 0.01, 1.0}, random).graph;
  const OdometryChain chain(graph);
  const auto loops = loopsOf(graph);
  for (std::size_t i = 0; i + 5 < loops.size(); i += 3) {
    const Constraint& a = graph.constraints[loops[i]];
    const Constraint& b = graph.constraints[loops[i + 5]];
    EXPECT_NEAR(*chain.disagreement(a, b), *chain.disagreement(b, a),
                0.05 * *chain.disagreement(a, b));
  }
}

}  // namespace
}  // namespace omega_slam::graph

#include "graph/solve_account.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "graph/manhattan_world.h"
#include "omega_slam/graph/linearization.h"

namespace omega_slam::experiments {
namespace {

graph::PoseGraph smallTown() {
  ManhattanConfig config;
  config.poses = 400;
  return driveManhattan(config).graph;
}

TEST(GraphContestants, FindTheSameMinimum) {
  if (!ceresContestant()) {
    GTEST_SKIP() << "built without Ceres";
  }
  const graph::PoseGraph graph = smallTown();
  SolveTask task;
  task.name = "town";
  task.repetitions = 1;
  const SolveAccount ours = accountFor(graph, task);
  task.solver = "ceres";
  const SolveAccount ceres = accountFor(graph, task);
  EXPECT_LT(ours.chi_square, 0.1 * graph::chiSquare(graph));
  EXPECT_NEAR(ours.chi_square, ceres.chi_square, 1e-3 * ours.chi_square);
  EXPECT_GT(ceres.iterations, 1);
}

TEST(GraphContestants, UnknownOnesAreNamed) {
  EXPECT_THROW(static_cast<void>(graphContestant("theirs")), std::invalid_argument);
}

TEST(SolveAccount, ScoresAFailureAsInfinite) {
  const graph::PoseGraph graph = smallTown();
  SolveAccount account;
  score(graph, {}, account);
  EXPECT_EQ(account.poses, 400u);
  EXPECT_TRUE(std::isinf(account.chi_square));
  score(graph, graph, account);
  EXPECT_DOUBLE_EQ(account.chi_square, account.initial_chi_square);
}

TEST(SolveAccount, RefusesASolutionOfAnotherGraph) {
  SolveAccount account;
  graph::PoseGraph smaller = smallTown();
  smaller.poses.pop_back();
  EXPECT_THROW(score(smallTown(), smaller, account), std::runtime_error);
}

}  // namespace
}  // namespace omega_slam::experiments

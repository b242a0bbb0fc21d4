#include <gtest/gtest.h>

#include <algorithm>

#include "omega_slam/graph/first_guess.h"
#include "omega_slam/graph/graph_file.h"
#include "omega_slam/graph/incremental_solver.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/robust_loops.h"
#include "omega_slam/graph/solver.h"
#include "support/paths.h"

namespace omega_slam::graph {
namespace {

/// A public graph with the least chi-square that any solver is known to have found.
struct Graph {
  const char* file;
  double least;
};

void PrintTo(const Graph& graph, std::ostream* stream) { *stream << graph.file; }

class PublicGraphs : public ::testing::TestWithParam<Graph> {
 protected:
  void SetUp() override {
    const auto path = test::dataFile(GetParam().file);
    if (!path) {
      GTEST_SKIP() << test::missingData(GetParam().file);
    }
    graph_ = loadGraph(*path).graph;
    config_.kernels.loop.kind = KernelKind::kNone;
  }

  PoseGraph graph_;
  SolverConfig config_;
};

TEST_P(PublicGraphs, AreSolvedToTheBestKnownMinimum) {
  applyGuess(graph_, FirstGuess::kBest);
  const SolveReport report = solve(graph_, config_);
  EXPECT_EQ(report.status, SolveStatus::kConverged);
  EXPECT_NEAR(report.chi_square, GetParam().least, 1e-4 * GetParam().least);
}

/// Pose by pose, with every constraint at the time that its later node comes.
TEST_P(PublicGraphs, AreSolvedAsTheyGrow) {
  std::vector<std::vector<Constraint>> arriving(graph_.poses.size());
  for (const Constraint& constraint : graph_.constraints) {
    arriving[std::max(constraint.from, constraint.to)].push_back(constraint);
  }
  IncrementalConfig config;
  config.solver = config_;
  IncrementalSolver solver(config);
  solver.addNode(graph_.poses[0], {});
  for (std::size_t node = 1; node < arriving.size(); ++node) {
    const Constraint& tie = arriving[node].front();
    const geometry::Pose2 guess = tie.to == node
                                      ? solver.graph().poses[tie.from] * tie.T_from_to
                                      : solver.graph().poses[tie.to] * tie.T_from_to.inverse();
    solver.addNode(guess, {tie});
    if (arriving[node].size() > 1) {
      solver.addConstraints({arriving[node].begin() + 1, arriving[node].end()});
    }
  }
  EXPECT_NEAR(chiSquare(solver.graph()), GetParam().least, 0.01 * GetParam().least);
  EXPECT_NEAR(solver.finish().chi_square, GetParam().least, 1e-4 * GetParam().least);
}

TEST_P(PublicGraphs, KeepTheirLoopsWhenAnyMayBeFalse) {
  const RobustReport report = solveWithDoubtfulLoops(graph_);
  EXPECT_EQ(report.solution.status, SolveStatus::kConverged) << report.solution.message;
  for (const LoopVerdict& loop : report.loops) {
    EXPECT_TRUE(loop.isBelieved()) << loop.constraint << " is " << toString(loop.standing);
  }
  EXPECT_NEAR(report.solution.chi_square, GetParam().least, 1e-4 * GetParam().least);
}

INSTANTIATE_TEST_SUITE_P(All, PublicGraphs,
                         ::testing::Values(Graph{"graphs/intel.g2o", 45.0047},
                                           Graph{"graphs/MIT.g2o", 41.1633},
                                           Graph{"graphs/CSAIL.g2o", 40.5551},
                                           Graph{"graphs/manhattan.g2o", 3549.0368}));

}  // namespace
}  // namespace omega_slam::graph

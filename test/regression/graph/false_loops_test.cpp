#include "support/false_loops.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "omega_slam/graph/graph_file.h"
#include "omega_slam/graph/robust_loops.h"
#include "support/paths.h"
#include "support/poses.h"

namespace omega_slam::graph {
namespace {

struct Spoilt {
  const char* file;
  int groups;
  int of_each;
};

void PrintTo(const Spoilt& spoilt, std::ostream* stream) {
  *stream << spoilt.file << " with " << spoilt.groups << " x " << spoilt.of_each;
}

class SpoiltPublicGraphs : public ::testing::TestWithParam<Spoilt> {};

TEST_P(SpoiltPublicGraphs, FalseLoopsAreNamedAndTrueOnesKept) {
  const auto path = test::dataFile(GetParam().file);
  if (!path) {
    GTEST_SKIP() << test::missingData(GetParam().file);
  }
  test::GraphProblem problem;
  problem.graph = loadGraph(*path).graph;
  PoseGraph clean = problem.graph;
  ASSERT_EQ(solveWithDoubtfulLoops(clean).solution.status, SolveStatus::kConverged);
  problem.truth = clean.poses;
  const std::size_t true_end = problem.graph.constraints.size();
  std::mt19937_64 random(1);
  test::addFalseLoops(problem, GetParam().groups, GetParam().of_each, random);
  for (const LoopVerdict& loop : solveWithDoubtfulLoops(problem.graph).loops) {
    EXPECT_EQ(loop.isBelieved(), loop.constraint < true_end)
        << loop.constraint << " is " << toString(loop.standing);
  }
  for (std::size_t i = 0; i < clean.poses.size(); ++i) {
    ASSERT_LT(distance(clean.poses[i], problem.graph.poses[i]), 0.01) << "pose " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(All, SpoiltPublicGraphs,
                         ::testing::Values(Spoilt{"graphs/intel.g2o", 100, 1},
                                           Spoilt{"graphs/intel.g2o", 20, 5},
                                           Spoilt{"graphs/manhattan.g2o", 100, 1},
                                           Spoilt{"graphs/manhattan.g2o", 20, 5}));

}  // namespace
}  // namespace omega_slam::graph

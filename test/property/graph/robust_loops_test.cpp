#include "omega_slam/graph/robust_loops.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "omega_slam/graph/node_removal.h"
#include "omega_slam/graph/solver.h"
#include "support/false_loops.h"
#include "support/poses.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

PoseGraph solved(PoseGraph graph) {
  SolverConfig config;
  config.kernels.loop.kind = KernelKind::kNone;
  config.limits.max_iterations = 100;
  solve(graph, config);
  return graph;
}

double worstGap(const PoseGraph& a, const PoseGraph& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.poses.size(); ++i) {
    worst = std::max(worst, distance(a.poses[i], b.poses[i]));
  }
  return worst;
}

std::size_t countBelieved(const RobustReport& report, std::size_t first, std::size_t end) {
  return static_cast<std::size_t>(
      std::count_if(report.loops.begin(), report.loops.end(), [&](const LoopVerdict& loop) {
        return loop.constraint >= first && loop.constraint < end && loop.isBelieved();
      }));
}

struct FalseCase {
  int groups;
  int of_each;
};

class FalseLoops : public testing::TestWithParam<FalseCase> {};

TEST_P(FalseLoops, AreNamedAndDoNotBendTheGraph) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    auto problem = test::drivenRounds({}, random);
    const PoseGraph clean = solved(problem.graph);
    const std::size_t true_end = problem.graph.constraints.size();
    test::addFalseLoops(problem, GetParam().groups, GetParam().of_each, random);
    const RobustReport report = solveWithDoubtfulLoops(problem.graph);
    EXPECT_EQ(report.solution.status, SolveStatus::kConverged) << report.solution.message;
    EXPECT_EQ(countBelieved(report, true_end, problem.graph.constraints.size()), 0U);
    EXPECT_GE(countBelieved(report, 0, true_end), 79U) << "of 80 true ones";
    EXPECT_LT(worstGap(problem.graph, clean), 0.02);
  }
}

INSTANTIATE_TEST_SUITE_P(FalseLoopsLaws, FalseLoops,
                         testing::Values(FalseCase{20, 1}, FalseCase{80, 1}, FalseCase{8, 5}),
                         [](const auto& a_case) {
                           return std::to_string(a_case.param.groups) + "GroupsOf" +
                                  std::to_string(a_case.param.of_each);
                         });

TEST(RobustLoopsLaws, WithoutFalseLoopsIsThePlainSolution) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const auto problem = test::drivenRounds({}, random);
    PoseGraph graph = problem.graph;
    const RobustReport report = solveWithDoubtfulLoops(graph);
    EXPECT_EQ(countBelieved(report, 0, graph.constraints.size()), report.loops.size());
    EXPECT_LT(worstGap(graph, solved(problem.graph)), 1e-3);
  }
}

TEST(RobustLoopsLaws, PosesGivenDoNotMatter) {
  std::mt19937_64 random(5);
  auto problem = test::drivenRounds({}, random);
  test::addFalseLoops(problem, 20, 1, random);
  PoseGraph scattered = problem.graph;
  for (std::size_t i = 1; i < scattered.poses.size(); ++i) {
    scattered.poses[i] = test::randomPose(20.0, 3.0, random);
  }
  const RobustReport report = solveWithDoubtfulLoops(problem.graph);
  EXPECT_EQ(solveWithDoubtfulLoops(scattered).solution.weights, report.solution.weights);
  EXPECT_LT(worstGap(scattered, problem.graph), 1e-9);
}

/// From whatever true loops the search begins, it ends where it does from none.
TEST_P(FalseLoops, AreNamedWhereMostLoopsAreSettled) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    auto problem = test::drivenRounds({}, random);
    const std::size_t true_end = problem.graph.constraints.size();
    test::addFalseLoops(problem, GetParam().groups, GetParam().of_each, random);
    PoseGraph from_none = problem.graph;
    const RobustReport report = solveWithDoubtfulLoops(from_none);
    std::vector<bool> settled(problem.graph.constraints.size(), false);
    std::bernoulli_distribution isSettled(0.7);
    std::generate_n(settled.begin(), true_end, [&] { return isSettled(random); });
    const RobustReport warm = solveWithDoubtfulLoops(problem.graph, {}, settled);
    EXPECT_EQ(warm.solution.weights, report.solution.weights);
    EXPECT_LE(warm.rounds, report.rounds);
    EXPECT_LT(worstGap(problem.graph, from_none), 1e-3);
  }
}

/// A loop that is settled may yet turn out to be false.
TEST(RobustLoopsLaws, SettledLoopIsWithdrawnWhereTheRestContradictsIt) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    auto problem = test::drivenRounds({}, random);
    const std::size_t true_end = problem.graph.constraints.size();
    test::addFalseLoops(problem, 1, 1, random);
    const std::vector<bool> settled(problem.graph.constraints.size(), true);
    const RobustReport report = solveWithDoubtfulLoops(problem.graph, {}, settled);
    EXPECT_EQ(countBelieved(report, true_end, true_end + 1), 0U);
    EXPECT_GE(countBelieved(report, 0, true_end), 79U);
  }
}

TEST(RobustLoopsLaws, WhereRetiredNodesLieDoesNotMatter) {
  std::mt19937_64 random(4);
  auto problem = test::drivenRounds({}, random);
  PoseGraph graph = solved(problem.graph);
  std::vector<NodeId> retired;
  for (NodeId node = 3; node < graph.poses.size(); node += 7) {
    if (retireNode(graph, node, 1e9)) {
      retired.push_back(node);
    }
  }
  ASSERT_GT(retired.size(), 5U);
  problem.graph = graph;
  test::addFalseLoops(problem, 10, 1, random);
  const auto isRetired = [&retired](NodeId node) {
    return std::binary_search(retired.begin(), retired.end(), node);
  };
  auto& constraints = problem.graph.constraints;
  constraints.erase(std::remove_if(constraints.begin(), constraints.end(),
                                   [&](const Constraint& constraint) {
                                     return isRetired(constraint.from) || isRetired(constraint.to);
                                   }),
                    constraints.end());
  PoseGraph near = problem.graph;
  PoseGraph far = problem.graph;
  for (const NodeId node : retired) {
    far.poses[node] = test::randomPose(1000.0, 3.0, random);
  }
  const RobustReport of_near = solveWithDoubtfulLoops(near);
  const RobustReport of_far = solveWithDoubtfulLoops(far);
  ASSERT_EQ(of_near.loops.size(), of_far.loops.size());
  for (std::size_t i = 0; i < of_near.loops.size(); ++i) {
    EXPECT_EQ(of_near.loops[i].standing, of_far.loops[i].standing);
    EXPECT_EQ(of_near.loops[i].chance, of_far.loops[i].chance);
  }
}

/// Variances a hundred times too large, or somewhat too small.
TEST(RobustLoopsLaws, BearsInformationOfTheWrongScale) {
  for (const double confidence : {0.01, 2.0}) {
    SCOPED_TRACE(confidence);
    std::mt19937_64 random(9);
    auto problem = test::drivenRounds({10, 3, 0.02, confidence}, random);
    const PoseGraph clean = solved(problem.graph);
    const std::size_t true_end = problem.graph.constraints.size();
    test::addFalseLoops(problem, 20, 1, random);
    test::addFalseLoops(problem, 4, 5, random);
    const RobustReport report = solveWithDoubtfulLoops(problem.graph);
    EXPECT_EQ(countBelieved(report, true_end, problem.graph.constraints.size()), 0U);
    EXPECT_LT(worstGap(problem.graph, clean), 0.05);
  }
}

/// After a long drive with poor odometry, the first loops fit whatever they say.
TEST(RobustLoopsLaws, VaguePredictionConfirmsNothing) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    auto problem = test::drivenRounds({15, 3, 0.06, 1.0}, random);
    const PoseGraph clean = solved(problem.graph);
    const std::size_t true_end = problem.graph.constraints.size();
    test::addFalseLoops(problem, 60, 1, random);
    const RobustReport report = solveWithDoubtfulLoops(problem.graph);
    EXPECT_LE(countBelieved(report, true_end, problem.graph.constraints.size()), 1U);
    EXPECT_GE(countBelieved(report, 0, true_end), 117U) << "of 120 true ones";
    EXPECT_LT(worstGap(problem.graph, clean), 0.5);
  }
}

/// One loop after a long drive: chance would let many pass, but nothing speaks against it.
TEST(RobustLoopsLaws, LoneLoopIsPresumedToBeRight) {
  std::mt19937_64 random(8);
  auto problem = test::drivenRounds({15, 2, 0.08, 1.0}, random);
  auto& constraints = problem.graph.constraints;
  constraints.erase(constraints.begin() + static_cast<std::ptrdiff_t>(problem.truth.size()) - 1,
                    constraints.end() - 1);
  const RobustReport report = solveWithDoubtfulLoops(problem.graph);
  ASSERT_EQ(report.loops.size(), 1U);
  EXPECT_EQ(report.loops[0].standing, LoopStanding::kLikely) << report.loops[0].chance;
}

TEST(RobustLoopsLaws, ReportAgreesWithTheGraph) {
  std::mt19937_64 random(2);
  auto problem = test::drivenRounds({}, random);
  test::addFalseLoops(problem, 10, 1, random);
  const RobustReport report = solveWithDoubtfulLoops(problem.graph);
  ASSERT_EQ(report.loops.size(), 90U);
  const double gate = RobustConfig{}.gate;
  for (const LoopVerdict& loop : report.loops) {
    EXPECT_EQ(report.solution.weights[loop.constraint], loop.weight);
    const bool is_far = loop.squared >= gate * gate;
    EXPECT_EQ(loop.standing == LoopStanding::kContradicted, is_far && !loop.isBelieved());
    EXPECT_FALSE(is_far && loop.isBelieved());
  }
  EXPECT_LT(report.solution.chi_square, 1.5 * 3.0 * 80.0) << "of the loops that are believed";
  EXPECT_GT(report.solution.factorizations, 0);
}

}  // namespace
}  // namespace omega_slam::graph

#include "graph/outliers.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "graph/manhattan_world.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/loop_consistency.h"

namespace omega_slam::experiments {
namespace {

using graph::Constraint;
using graph::ConstraintKind;

CleanGraph smallTown() {
  ManhattanConfig config;
  config.poses = 300;
  return cleanGraph("town", driveManhattan(config).graph);
}

TEST(Outliers, CleanGraphIsSolvedAndItsNoiseKnown) {
  const CleanGraph clean = smallTown();
  EXPECT_LT(graph::chiSquare(clean.solution), 0.1 * graph::chiSquare(clean.graph));
  EXPECT_GT(clean.stated_noise, 0.02) << "that of one step";
  EXPECT_LT(clean.stated_noise, 1.0);
  EXPECT_NEAR(clean.shown_noise / clean.stated_noise, 1.0, 0.1) << "measures as well as it says";
}

TEST(Outliers, AreLoopsThatAreFarOffAndTheSameForTheSameSeed) {
  const CleanGraph clean = smallTown();
  const graph::PoseGraph spoilt = withFalseLoops(clean, {40, 1, 3});
  const std::size_t true_end = clean.graph.constraints.size();
  ASSERT_EQ(spoilt.constraints.size(), true_end + 40);
  for (std::size_t k = true_end; k < spoilt.constraints.size(); ++k) {
    const Constraint& loop = spoilt.constraints[k];
    EXPECT_EQ(loop.kind, ConstraintKind::kLoop);
    EXPECT_EQ(graph::faultOf(loop, spoilt.poses.size()), "");
    EXPECT_GT(graph::chiSquare(clean.solution, loop), 100.0);
  }
  const auto claimOf = [&](std::uint64_t seed) -> Eigen::Vector3d {
    return withFalseLoops(clean, {40, 1, seed}).constraints.back().T_from_to.vector();
  };
  EXPECT_EQ(claimOf(3), claimOf(3));
  EXPECT_NE(claimOf(3), claimOf(4));
}

TEST(Outliers, AgreeWithinTheirGroup) {
  const CleanGraph clean = smallTown();
  graph::PoseGraph spoilt = withFalseLoops(clean, {20, 5, 1});
  std::vector<std::size_t> false_loops;
  for (std::size_t k = clean.graph.constraints.size(); k < spoilt.constraints.size(); ++k) {
    false_loops.push_back(k);
  }
  for (const auto& others : graph::agreeingLoops(spoilt, false_loops)) {
    EXPECT_GE(others.size(), 4u);
  }
}

TEST(Outliers, AccountCountsWhatIsKeptAndDropped) {
  const CleanGraph clean = smallTown();
  const OutlierAccount plain = outlierAccountFor(clean, {10, 1, 1}, "plain");
  EXPECT_EQ(plain.false_kept, 10u);
  EXPECT_EQ(plain.true_dropped, 0u);
  EXPECT_GT(plain.error, 2.0 * plain.shown_noise);
  const OutlierAccount doubt = outlierAccountFor(clean, {10, 1, 1}, "doubt");
  EXPECT_EQ(doubt.false_kept, 0u);
  EXPECT_LT(doubt.error, doubt.shown_noise);
  EXPECT_GT(doubt.true_loops, 100u);
}

TEST(Outliers, SweepTriesAllCombinationsAfterTheCleanGraph) {
  OutlierSweep sweep;
  sweep.counts = {5, 10};
  sweep.seeds = 2;
  sweep.solver = "scaling";
  std::vector<OutlierAccount> accounts;
  sweepOutliers(smallTown(), sweep,
                [&](const OutlierAccount& account) { accounts.push_back(account); });
  ASSERT_EQ(accounts.size(), 1u + 2u * 2u * 2u);
  EXPECT_EQ(accounts.front().wanted.count, 0u);
  EXPECT_EQ(accounts.back().wanted.count, 10u);
  EXPECT_EQ(accounts.back().wanted.group, 5u);
}

TEST(Outliers, UnknownSolverIsRefused) {
  EXPECT_THROW(doubtingSolver("hope"), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::experiments

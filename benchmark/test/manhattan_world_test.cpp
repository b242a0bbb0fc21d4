#include "graph/manhattan_world.h"

#include <gtest/gtest.h>

#include "omega_slam/graph/graph_file.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/topology.h"

namespace omega_slam::experiments {
namespace {

ManhattanWorld smallTown(std::uint64_t seed) {
  ManhattanConfig config;
  config.poses = 600;
  config.seed = seed;
  return driveManhattan(config);
}

/// Constraints that do not merely lead from pose to pose.
double loopsAPose(const graph::PoseGraph& graph) {
  const auto poses = static_cast<double>(graph.poses.size());
  return (static_cast<double>(graph.constraints.size()) - poses + 1.0) / poses;
}

TEST(ManhattanWorld, IsTheSameForTheSameSeed) {
  EXPECT_EQ(toG2o(smallTown(7).graph), toG2o(smallTown(7).graph));
  EXPECT_NE(toG2o(smallTown(7).graph), toG2o(smallTown(8).graph));
}

TEST(ManhattanWorld, HasAStepBetweenPosesAndEveryPoseInOnePart) {
  const ManhattanWorld world = smallTown(1);
  ASSERT_EQ(world.truth.size(), 600u);
  ASSERT_EQ(world.graph.poses.size(), 600u);
  EXPECT_EQ(graph::spanningForest(world.graph).roots.size(), 1u);
  for (std::size_t k = 1; k < world.truth.size(); ++k) {
    const Eigen::Vector2d step = world.truth[k].translation() - world.truth[k - 1].translation();
    EXPECT_NEAR(step.norm(), 1.0, 1e-12) << k;
  }
}

TEST(ManhattanWorld, HasAsManyLoopsAPoseInTownsOfAnySize) {
  for (const std::size_t poses : {1000u, 20000u}) {
    ManhattanConfig config;
    config.poses = poses;
    EXPECT_NEAR(loopsAPose(driveManhattan(config).graph), 0.6, 0.1) << poses;
  }
}

TEST(ManhattanWorld, RecognisesEveryThirdReturnIfAskedTo) {
  ManhattanConfig config;
  config.poses = 1000;
  const double all = loopsAPose(driveManhattan(config).graph);
  config.returns_a_loop = 3;
  EXPECT_NEAR(loopsAPose(driveManhattan(config).graph), all / 3.0, 0.03);
}

TEST(ManhattanWorld, MeasuresAsWellAsItSays) {
  const ManhattanWorld world = smallTown(3);
  graph::PoseGraph at_truth = world.graph;
  at_truth.poses = world.truth;
  const double mean =
      graph::chiSquare(at_truth) / static_cast<double>(3 * at_truth.constraints.size());
  EXPECT_NEAR(mean, 1.0, 0.1);
}

}  // namespace
}  // namespace omega_slam::experiments

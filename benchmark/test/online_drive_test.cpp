#include "graph/online_drive.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "graph/contestants.h"
#include "graph/manhattan_world.h"
#include "omega_slam/graph/linearization.h"

namespace omega_slam::experiments {
namespace {

graph::PoseGraph smallTown() {
  ManhattanConfig config;
  config.poses = 150;
  return driveManhattan(config).graph;
}

TEST(OnlineDrive, EndsWhereTheWholeGraphIsSolved) {
  graph::PoseGraph graph = smallTown();
  const OnlineDrive drive = playOnline(graph);
  EXPECT_EQ(drive.seconds.size(), graph.poses.size());
  graph.poses = solveOurselves(graph).poses;
  const double least = graph::chiSquare(graph);
  graph.poses = drive.solution.poses;
  EXPECT_NEAR(graph::chiSquare(graph), least, 1e-3 * least);
}

TEST(OnlineDrive, OrderOfConstraintsIsNoMatter) {
  graph::PoseGraph graph = smallTown();
  const Solution before = playOnline(graph).solution;
  std::reverse(graph.constraints.begin(), graph.constraints.end());
  const Solution after = playOnline(graph).solution;
  for (std::size_t node = 0; node < graph.poses.size(); ++node) {
    EXPECT_LT(geometry::distance(before.poses[node], after.poses[node]), 1e-4);
  }
}

TEST(OnlineDrive, TableHasALineForEachPose) {
  OnlineDrive drive;
  drive.seconds = {1e-6, 2.5e-3};
  EXPECT_EQ(updateTable(drive), "pose,microseconds\n0,1.0\n1,2500.0\n");
}

}  // namespace
}  // namespace omega_slam::experiments

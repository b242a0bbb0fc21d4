// SLAM of a simulated drive, without ROS: simulator, pipeline and evaluation in one process.

#include "support/simulated_run.h"

#include <gtest/gtest.h>

#include "omega_slam/evaluation/resemblance.h"
#include "omega_slam/evaluation/trajectory_error.h"
#include "omega_slam/grid/map_file.h"
#include "omega_slam/slam/pipeline.h"
#include "support/seeds.h"

namespace omega_slam {
namespace {

struct Outcome {
  evaluation::TrajectoryError error;
  evaluation::Resemblance resemblance;
};

Outcome mapRun(const test::SimulatedRun& run) {
  slam::Pipeline pipeline;
  for (const io::ScanRecord& record : run.records) {
    pipeline.process(record.scan, record.mount, record.T_odom_base, record.motion_during_sweep);
  }
  pipeline.finish();
  Outcome outcome;
  outcome.error = evaluation::absoluteTrajectoryError(pipeline.trajectory(), run.truth);
  outcome.resemblance = evaluation::compareMaps(
      pipeline.map({}), grid::toOccupancyGrid(grid::loadMapImage(run.world.file.map)),
      {outcome.error.T_truth_map, run.world.file.start.translation()});
  return outcome;
}

/// Twelve seeds gave an error of 0.048 +- 0.023 m, a resemblance of 0.968 +- 0.012 and a coverage
/// of 0.967 +- 0.004; bounds are four deviations away.
TEST(SimulatedRun, LabIsMapped) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    const test::SimulatedRun run = test::driveRoute("lab", seed);
    ASSERT_TRUE(run.arrived);
    ASSERT_EQ(run.collisions, 0);
    const Outcome outcome = mapRun(run);
    RecordProperty("ate_mm", static_cast<int>(1e3 * outcome.error.translation.mean));
    EXPECT_EQ(outcome.error.matched, run.records.size());
    EXPECT_LT(outcome.error.translation.mean, 0.14);
    EXPECT_GT(outcome.resemblance.score(), 0.92);
    EXPECT_GT(outcome.resemblance.coverage(), 0.95);
  }
}

/// Two minutes of the lab with odometry twice as bad as a Kobuki's.
TEST(SimulatedRun, BadOdometryIsMended) {
  const test::SimulatedRun run = test::driveRoute("lab", 1, 2.0, 120.0);
  geometry::Trajectory odometry;
  for (const io::ScanRecord& record : run.records) {
    odometry.push_back({record.scan.stamp, record.T_odom_base});
  }
  const double by_wheels =
      evaluation::absoluteTrajectoryError(odometry, run.truth).translation.mean;
  EXPECT_LT(mapRun(run).error.translation.mean, 0.5 * by_wheels);
}

}  // namespace
}  // namespace omega_slam

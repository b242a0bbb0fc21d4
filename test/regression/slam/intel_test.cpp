// The Intel Research Lab, a real log that drifts by tens of metres, scored with the ground-truth
// relations of Kuemmerle et al. 2009.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "omega_slam/evaluation/relations.h"
#include "omega_slam/io/carmen_source.h"
#include "omega_slam/io/trajectory_file.h"
#include "omega_slam/slam/pipeline.h"
#include "support/paths.h"

namespace omega_slam {
namespace {

/// The first quarter of an hour at every fifth scan, with loops: enough to tell a broken chain from
/// a whole one.
TEST(IntelResearchLab, BecomesOneBuilding) {
  const auto log = test::dataFile("logs/intel/intel_2726_fullrun_rawodom.clf");
  const auto relations = test::dataFile("logs/intel/intel.relations");
  if (!log || !relations) {
    GTEST_SKIP() << test::missingData("logs/intel");
  }
  io::CarmenSource source(*log, {});
  slam::Pipeline pipeline;
  geometry::Trajectory odometry;
  double first = 0.0;
  while (const auto record = source.next()) {
    first = odometry.empty() ? record->scan.stamp : first;
    if (record->scan.stamp - first > 900.0) {
      break;
    }
    pipeline.process(record->scan, record->mount, record->T_odom_base);
    odometry.push_back({record->scan.stamp, record->T_odom_base});
  }
  pipeline.finish();
  const auto truth = io::readRelations(*relations);
  const auto trajectory = pipeline.trajectory();
  ASSERT_EQ(trajectory.size(), odometry.size());
  const auto score = evaluation::scoreRelations(trajectory, truth);
  const auto by_wheels = evaluation::scoreRelations(odometry, truth);
  EXPECT_GT(score.covered, 700U);
  EXPECT_GT(by_wheels.translation.mean, 1.0) << "the log is not the one that was meant";
  EXPECT_LT(score.translation.mean, 0.12);
  EXPECT_LT(score.rotation.mean, 0.06);
}

/// The first 1088 s without three minutes of them, after which the odometry is metres off: each
/// time, the robot is found again among what it had seen.
TEST(IntelResearchLab, MinutesInTheDarkAreBridged) {
  const auto log = test::dataFile("logs/intel/intel_5505_first1088s_rawodom.clf");
  const auto relations = test::dataFile("logs/intel/intel.relations");
  if (!log || !relations) {
    GTEST_SKIP() << test::missingData("logs/intel");
  }
  io::CarmenSource source(*log, {});
  slam::Pipeline pipeline;
  std::optional<double> first;
  while (const auto record = source.next()) {
    first = first.value_or(record->scan.stamp);
    const double since = record->scan.stamp - *first;
    if (since < 272.0 || std::fmod(since, 272.0) > 60.0) {
      pipeline.process(record->scan, record->mount, record->T_odom_base);
    }
  }
  pipeline.finish();
  const auto score =
      evaluation::scoreRelations(pipeline.trajectory(), io::readRelations(*relations));
  EXPECT_GT(score.covered, 700U);

  EXPECT_LT(score.translation.mean, 0.1);
}

}  // namespace
}  // namespace omega_slam

// Tracking on a map with nothing but odometry for a guess, on the log of the Intel Research Lab,
// scored with the ground-truth relations of Kuemmerle et al. 2009.

#include <gtest/gtest.h>

#include <cmath>

#include "omega_slam/evaluation/relations.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/io/carmen_source.h"
#include "omega_slam/io/trajectory_file.h"
#include "omega_slam/matching/map_matcher.h"
#include "omega_slam/sensing/scan_intake.h"
#include "omega_slam/slam/keyframe.h"
#include "support/paths.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

/// Each scan of a log is matched; one is put in wherever the robot has moved on.
/// @param spacing [m], [rad] between those
geometry::Trajectory trackLog(const std::filesystem::path& log, double spacing) {
  io::CarmenSource source(log, {});
  const sensing::ScanIntake intake{{}};
  const MapMatcher matcher;
  LocalMap map;
  geometry::Trajectory trajectory;
  Pose2 T_odom_last;
  Pose2 T_map_newest;
  while (const auto record = source.next()) {
    const auto sweep = intake.process(record->scan, record->mount).sweep;
    const Pose2 step = relativePose(T_odom_last, record->T_odom_base);
    T_odom_last = record->T_odom_base;
    Pose2 T_map_base;
    if (!trajectory.empty()) {
      T_map_base = trajectory.back().pose * step;
    }
    if (sweep) {
      const View view = slam::viewOf(*sweep);
      if (!trajectory.empty()) {
        T_map_base = matcher.track(map, view, T_map_base).T_reference_scan;
      }
      const Pose2 way = relativePose(T_map_newest, T_map_base);
      if (trajectory.empty() || way.translation().norm() > spacing ||
          std::abs(way.theta) > spacing) {
        EXPECT_TRUE(map.insert(view, T_map_base));
        T_map_newest = T_map_base;
      }
    }
    trajectory.push_back({record->scan.stamp, T_map_base});
  }
  return trajectory;
}

TEST(MapTracking, IntelResearchLabWithoutAGraph) {
  const auto log = test::dataFile("logs/intel/intel_5505_first1088s_rawodom.clf");
  const auto relations = test::dataFile("logs/intel/intel.relations");
  if (!log || !relations) {
    GTEST_SKIP() << test::missingData("logs/intel");
  }
  const auto score = evaluation::scoreRelations(trackLog(*log, 0.4), io::readRelations(*relations));
  EXPECT_GT(score.covered, 1000U);
  EXPECT_LT(score.translation.mean, 0.020);
  EXPECT_LT(score.rotation.mean, geometry::degreesToRadians(0.30));
}

}  // namespace
}  // namespace omega_slam::matching

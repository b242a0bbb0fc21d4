// The Intel Research Lab, a real log that drifts by tens of metres, scored with the ground-truth
// relations of Kuemmerle et al. 2009.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "omega_slam/evaluation/relations.h"
#include "omega_slam/io/carmen_source.h"
#include "omega_slam/io/trajectory_file.h"
#include "omega_slam/slam/pipeline.h"
#include "support/paths.h"

namespace omega_slam {
namespace {

const std::string kSparse = "logs/intel/intel_2726_fullrun_rawodom.clf";
const std::string kDense = "logs/intel/intel_5505_first1088s_rawodom.clf";

class IntelResearchLab : public testing::Test {
 protected:
  void SetUp() override {
    relations_ = test::dataFile("logs/intel/intel.relations");
    if (!relations_ || !test::dataFile(kSparse) || !test::dataFile(kDense)) {
      GTEST_SKIP() << test::missingData("logs/intel");
    }
  }

  /// Plays a log, as far as it is seen.
  /// @param isSeen by the seconds since the first
  void play(const std::string& log, const std::function<bool(double)>& isSeen) {
    io::CarmenSource source(*test::dataFile(log), {});
    std::optional<double> first;
    while (const auto record = source.next()) {
      first = first.value_or(record->scan.stamp);
      if (isSeen(record->scan.stamp - *first)) {
        pipeline_.process(record->scan, record->mount, record->T_odom_base);
        odometry_.push_back({record->scan.stamp, record->T_odom_base});
      }
    }
    pipeline_.finish();
  }

  [[nodiscard]] evaluation::RelationsScore score(const geometry::Trajectory& trajectory) const {
    return evaluation::scoreRelations(trajectory, io::readRelations(*relations_));
  }

  slam::Pipeline pipeline_;
  geometry::Trajectory odometry_;
  std::optional<std::filesystem::path> relations_;
};

/// The first quarter of an hour at every fifth scan, with loops: enough to tell a broken chain from
/// a whole one.
TEST_F(IntelResearchLab, BecomesOneBuilding) {
  play(kSparse, [](double since) { return since <= 900.0; });
  const auto trajectory = pipeline_.trajectory();
  ASSERT_EQ(trajectory.size(), odometry_.size());
  const auto by_slam = score(trajectory);
  const auto by_wheels = score(odometry_);
  EXPECT_GT(by_slam.covered, 700U);
  EXPECT_GT(by_wheels.translation.mean, 1.0) << "the log is not the one that was meant";
  EXPECT_LT(by_slam.translation.mean, 0.12);
  EXPECT_LT(by_slam.rotation.mean, 0.06);
}

/// The first 1088 s without three minutes of them, after which the odometry is metres off: each
/// time, the robot is found again among what it had seen. Gave 0.042 m.
TEST_F(IntelResearchLab, MinutesInTheDarkAreBridged) {
  play(kDense, [](double since) { return since < 272.0 || std::fmod(since, 272.0) > 60.0; });
  const auto by_slam = score(pipeline_.trajectory());
  EXPECT_GT(by_slam.covered, 700U);
  EXPECT_LT(by_slam.translation.mean, 0.1);
}

}  // namespace
}  // namespace omega_slam

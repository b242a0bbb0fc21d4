#include <gtest/gtest.h>

#include <random>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/io/trajectory_file.h"
#include "support/seeds.h"
#include "support/temporary_folder.h"

namespace omega_slam::io {
namespace {

TEST(TrajectoryFileProperty, ReadingGivesWhatWasWritten) {
  const test::TemporaryFolder folder;
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> stamp(0.0, 2e9);
    std::uniform_real_distribution<double> place(-1000.0, 1000.0);
    std::uniform_real_distribution<double> angle(-geometry::kPi, geometry::kPi);
    geometry::Trajectory trajectory;
    for (int k = 0; k < 500; ++k) {
      trajectory.push_back({stamp(random), {place(random), place(random), angle(random)}});
    }
    ASSERT_EQ(writeTrajectory(folder.path() / "t.tum", trajectory), "");
    const geometry::Trajectory again = readTrajectory(folder.path() / "t.tum");
    ASSERT_EQ(again.size(), trajectory.size());
    for (std::size_t k = 0; k < again.size(); ++k) {
      EXPECT_NEAR(again[k].stamp, trajectory[k].stamp, 1e-6);
      EXPECT_LT(geometry::distance(again[k].pose, trajectory[k].pose), 1e-9);
      EXPECT_LT(std::abs(geometry::angleDifference(again[k].pose.theta, trajectory[k].pose.theta)),
                1e-8);
    }
    EXPECT_EQ(toTum(again).size(), toTum(trajectory).size());
  }
}

}  // namespace
}  // namespace omega_slam::io

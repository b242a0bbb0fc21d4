#include "omega_slam/simulation/route_drive.h"

#include <gtest/gtest.h>

#include "omega_slam/sensing/sweep_duration.h"
#include "support/paths.h"

namespace omega_slam::simulation {
namespace {

constexpr double kSeconds = 8.0;

RouteDrive driveLab(const TurtleBotConfig& config) {
  return driveRoute(loadWorld(test::sourceFolder() / "maps/lab.world.yaml"), config, kSeconds);
}

const geometry::Pose2& truthAt(const RouteDrive& drive, double stamp) {
  std::size_t k = 0;
  while (drive.truth[k].stamp < stamp - 1e-6) {
    ++k;
  }
  return drive.truth[k].pose;
}

TEST(RouteDrive, IsCutOffInTime) {
  const RouteDrive drive = driveLab({});
  EXPECT_FALSE(drive.arrived);
  EXPECT_NEAR(drive.truth.back().stamp, kSeconds, 0.021);
  EXPECT_NEAR(static_cast<double>(drive.scans.size()), 10.0 * (kSeconds - 1.0), 2.0);
}

TEST(RouteDrive, WithoutNoiseTheOdometryIsTheTruth) {
  TurtleBotConfig config;
  config.odometry = withNoise(config.odometry, 0.0);
  const RouteDrive drive = driveLab(config);
  const geometry::Pose2 T_world_odom = drive.truth.front().pose;
  for (const DriveScan& taken : drive.scans) {
    const geometry::Pose2 T_world_base = T_world_odom * taken.T_odom_base;
    EXPECT_LT(distance(T_world_base, truthAt(drive, taken.scan.stamp)), 0.02) << taken.scan.stamp;
    const double end = taken.scan.stamp + sensing::sweepDuration(taken.scan);
    EXPECT_LT(distance(T_world_base * taken.motion_during_sweep, truthAt(drive, end)), 0.02);
  }
}

TEST(RouteDrive, NoiseGrowsWithTheFactor) {
  const auto errorAtTheEnd = [](double factor) {
    TurtleBotConfig config;
    config.odometry = withNoise(config.odometry, factor);
    const RouteDrive drive = driveLab(config);
    const DriveScan& last = drive.scans.back();
    return distance(drive.truth.front().pose * last.T_odom_base, truthAt(drive, last.scan.stamp));
  };
  EXPECT_GT(errorAtTheEnd(8.0), 2.0 * errorAtTheEnd(1.0));
}

}  // namespace
}  // namespace omega_slam::simulation

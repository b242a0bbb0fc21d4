#include "omega_slam/simulation/route_drive.h"

#include <algorithm>

#include "omega_slam/motion/odometry_buffer.h"
#include "omega_slam/sensing/sweep_duration.h"
#include "omega_slam/simulation/route_driver.h"

namespace omega_slam::simulation {
namespace {

constexpr double kHorizon = 2.0;  // [s] of odometry that is kept for a scan to come

DriveScan withOdometry(const sensing::LaserScan& scan, const motion::OdometryBuffer& odometry,
                       double now) {
  const double last_beam = scan.stamp + sensing::sweepDuration(scan);
  const geometry::Pose2 T_odom_base = odometry.at(scan.stamp).value();
  const geometry::Pose2 T_odom_end = odometry.at(std::min(last_beam, now)).value();
  return {scan, T_odom_base, relativePose(T_odom_base, T_odom_end)};
}

}  // namespace

RouteDrive driveRoute(const LoadedWorld& world, const TurtleBotConfig& config, double seconds) {
  RouteDrive drive;
  TurtleBot robot(world.world, world.file.start, config);
  RouteDriver driver({}, world.file.route);
  motion::OdometryBuffer odometry(kHorizon);
  odometry.add(robot.time(), {});
  drive.truth.push_back({robot.time(), robot.truth().T_world_base});
  while (!drive.arrived && robot.time() < seconds) {
    (void)robot.command(driver.update(robot.time(), robot.truth().T_world_base));
    const TurtleBotEvents events = robot.step();
    odometry.add(events.odometry.stamp, events.odometry.T_odom_base);
    drive.truth.push_back({events.truth.stamp, events.truth.T_world_base});
    if (events.scan) {
      drive.scans.push_back(withOdometry(*events.scan, odometry, robot.time()));
    }
    drive.arrived = driver.status().state == RouteStatus::State::kDone;
  }
  drive.collisions = robot.collisions();
  return drive;
}

}  // namespace omega_slam::simulation

#include "support/simulated_run.h"

#include <algorithm>

#include "omega_slam/motion/odometry_buffer.h"
#include "omega_slam/simulation/route_driver.h"
#include "omega_slam/simulation/turtlebot.h"
#include "support/paths.h"

namespace omega_slam::test {

using geometry::Pose2;

namespace {

simulation::TurtleBotConfig robotWith(std::uint64_t seed, double noise_factor) {
  simulation::TurtleBotConfig config;
  config.seed = seed;
  auto& noise = config.odometry.noise;
  noise.rotation_per_rotation *= noise_factor;
  noise.rotation_per_translation *= noise_factor;
  noise.translation_per_rotation *= noise_factor;
  noise.translation_per_translation *= noise_factor;
  return config;
}

io::ScanRecord recordOf(const sensing::LaserScan& scan, const Pose2& T_base_laser,
                        const motion::OdometryBuffer& odometry, double now) {
  io::ScanRecord record;
  record.scan = scan;
  record.mount.T_base_laser = T_base_laser;
  record.T_odom_base = odometry.at(scan.stamp).value();
  const double last_beam =
      scan.stamp + scan.time_increment * static_cast<double>(scan.ranges.size() - 1);
  record.motion_during_sweep =
      relativePose(record.T_odom_base, odometry.at(std::min(last_beam, now)).value());
  return record;
}

}  // namespace

SimulatedRun driveRoute(const std::string& world, std::uint64_t seed, double noise_factor,
                        double seconds) {
  SimulatedRun run;
  run.world = simulation::loadWorld(sourceFolder() / "maps" / (world + ".world.yaml"));
  const simulation::TurtleBotConfig config = robotWith(seed, noise_factor);
  simulation::TurtleBot robot(run.world.world, run.world.file.start, config);
  simulation::RouteDriver driver({}, run.world.file.route);
  motion::OdometryBuffer odometry(2.0);
  motion::OdometryBuffer truth(2.0);
  odometry.add(robot.time(), {});
  truth.add(robot.time(), robot.truth().T_world_base);
  run.truth.push_back({robot.time(), robot.truth().T_world_base});
  while (!run.arrived && robot.time() < seconds) {
    (void)robot.command(driver.update(robot.time(), robot.truth().T_world_base));
    const simulation::TurtleBotEvents events = robot.step();
    odometry.add(events.odometry.stamp, events.odometry.T_odom_base);
    truth.add(events.truth.stamp, events.truth.T_world_base);
    run.truth.push_back({events.truth.stamp, events.truth.T_world_base});
    if (events.scan) {
      if (run.records.empty()) {
        run.T_world_start = truth.at(events.scan->stamp).value();
      }
      run.records.push_back(recordOf(*events.scan, config.T_base_laser, odometry, robot.time()));
    }
    run.arrived = driver.status().state == simulation::RouteStatus::State::kDone;
  }
  run.collisions = robot.collisions();
  return run;
}

}  // namespace omega_slam::test

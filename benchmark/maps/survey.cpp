#include "maps/survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "omega_slam/grid/map_file.h"
#include "omega_slam/motion/odometry_buffer.h"
#include "omega_slam/sensing/scan_intake.h"
#include "omega_slam/sensing/sweep_duration.h"
#include "omega_slam/slam/pipeline.h"

namespace omega_slam::experiments {
namespace {

using geometry::Pose2;
using simulation::RouteDrive;

RouteDrive drive(const Site& site, const simulation::TurtleBotConfig& robot) {
  RouteDrive drive = simulation::driveRoute(site.world, robot, kDrivePatience);
  if (!drive.arrived) {
    throw std::runtime_error(
        fmt::format("In {} the robot did not come to the end of its route.", site.name));
  }
  return drive;
}

/// The truth, to be asked at any time of the drive.
motion::OdometryBuffer truthOf(const RouteDrive& drive) {
  motion::OdometryBuffer truth(kDrivePatience);
  for (const geometry::StampedPose2& entry : drive.truth) {
    truth.add(entry.stamp, entry.pose);
  }
  return truth;
}

/// The sweeps with these stamps, placed by the truth, free of the true motion during the sweep.
std::vector<PlacedSweep> placeByTruth(const RouteDrive& drive, const sensing::LaserMount& mount,
                                      const std::vector<double>& stamps) {
  const motion::OdometryBuffer truth = truthOf(drive);
  std::map<double, const simulation::DriveScan*> scans;
  for (const simulation::DriveScan& taken : drive.scans) {
    scans[sensing::middleOfSweep(taken.scan)] = &taken;
  }
  std::vector<PlacedSweep> placed;
  for (const double stamp : stamps) {
    const sensing::LaserScan& scan = scans.at(stamp)->scan;
    const Pose2 T_world_base = truth.at(scan.stamp).value();
    const double end =
        std::min(scan.stamp + sensing::sweepDuration(scan), drive.truth.back().stamp);
    const Pose2 motion = relativePose(T_world_base, truth.at(end).value());
    // A new intake each time: what it remembers of earlier scans is no concern here.
    const auto result = sensing::ScanIntake({}).process(scan, mount, motion);
    if (result.sweep) {
      placed.push_back({*result.sweep, T_world_base * result.T_start_sweep});
    }
  }
  return placed;
}

simulation::TurtleBotConfig withoutNoise(simulation::TurtleBotConfig robot) {
  robot.hokuyo.near_accuracy = 0.0;
  robot.hokuyo.far_accuracy = 0.0;
  return robot;
}

}  // namespace

Site loadSite(const std::string& name, const std::filesystem::path& map_file,
              const Eigen::Vector2d& near) {
  const grid::MapImage image = grid::loadMapImage(map_file);
  Site site;
  site.name = name;
  site.truth = grid::toOccupancyGrid(image);
  const CoverageRoute route = planCoverage(site.truth, near);
  site.seen_from_route = route.seen;
  site.world.world = std::make_shared<simulation::World>(simulation::World::fromImage(image));
  site.world.file.map = map_file;
  site.world.file.route = route.waypoints;
  // Straight ahead as the map's x axis, so that the maps' cells are parallel.
  site.world.file.start = {route.start.x(), route.start.y(), 0.0};
  return site;
}

Survey survey(const Site& site, std::uint64_t seed) {
  simulation::TurtleBotConfig robot;
  robot.seed = seed;
  const RouteDrive noisy = drive(site, robot);
  const sensing::LaserMount mount{robot.T_base_laser, false};
  slam::Pipeline pipeline;
  Survey result;
  for (const simulation::DriveScan& taken : noisy.scans) {
    result.loops +=
        pipeline.process(taken.scan, mount, taken.T_odom_base, taken.motion_during_sweep).loops;
  }
  pipeline.finish();
  std::vector<double> stamps;
  for (const slam::KeyframePtr& keyframe : pipeline.keyframes()) {
    stamps.push_back(keyframe->sweep.stamp);
    result.by_slam.push_back({keyframe->sweep, pipeline.graph().poses[keyframe->id]});
  }
  result.by_truth = placeByTruth(noisy, mount, stamps);
  // The robot's driver sees the truth, so it drives the same way again.
  result.without_noise = placeByTruth(drive(site, withoutNoise(robot)), mount, stamps);
  result.error = evaluation::absoluteTrajectoryError(pipeline.trajectory(), noisy.truth);
  for (std::size_t k = 1; k < noisy.truth.size(); ++k) {
    result.distance += geometry::distance(noisy.truth[k - 1].pose, noisy.truth[k].pose);
  }
  result.duration = noisy.truth.back().stamp - noisy.truth.front().stamp;
  result.scans = noisy.scans.size();
  return result;
}

}  // namespace omega_slam::experiments

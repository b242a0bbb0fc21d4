#include "slam/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/io/log_source.h"
#include "omega_slam/io/trajectory_file.h"
#include "omega_slam/simulation/route_drive.h"

namespace omega_slam::experiments {
namespace {

using simulation::HokuyoConfig;

/// [s] A pose is taken for that of a relation's stamp within it.
constexpr double kSameMoment = 0.1;

/// A laser of so many beams over so many degrees.
HokuyoConfig fan(int beams, double degrees, double rate, double range_max) {
  HokuyoConfig laser;
  laser.beams = beams;
  laser.angle_increment = geometry::degreesToRadians(degrees);
  laser.rate = rate;
  laser.range_max = range_max;
  laser.no_return_is_inf = true;
  return laser;
}

HokuyoConfig sick() {
  HokuyoConfig laser = fan(181, 1.0, 10.0, 8.0);
  laser.dark_range = 4.0;
  laser.near_accuracy = 0.015;
  laser.near_limit = 8.0;
  return laser;
}

HokuyoConfig rplidar() {
  HokuyoConfig laser = fan(360, 1.0, 5.0, 12.0);
  laser.range_min = 0.15;
  laser.dark_range = 6.0;
  laser.near_limit = 1.0;
  return laser;
}

/// The LDS-01 of a TurtleBot3, from its data sheet.
HokuyoConfig lds() {
  HokuyoConfig laser = fan(360, 1.0, 5.0, 3.5);
  laser.range_min = 0.12;
  laser.dark_range = 2.0;
  laser.near_accuracy = 0.015;
  laser.near_limit = 0.5;
  laser.far_accuracy = 0.05;
  return laser;
}

/// The line of a depth camera's picture that stands in for a laser where there is none.
HokuyoConfig kinect() {
  HokuyoConfig laser = fan(640, 57.0 / 640.0, 10.0, 5.0);
  laser.range_min = 0.45;
  laser.dark_range = 4.0;
  laser.near_accuracy = 0.01;
  laser.far_accuracy = 0.02;
  laser.no_return_is_inf = false;
  return laser;
}

HokuyoConfig utm() {
  HokuyoConfig laser = fan(1081, 0.25, 40.0, 30.0);
  laser.range_min = 0.1;
  laser.dark_range = 10.0;
  laser.near_limit = 10.0;
  laser.far_accuracy = 0.003;
  return laser;
}

const std::map<std::string, std::function<HokuyoConfig()>>& lasers() {
  static const std::map<std::string, std::function<HokuyoConfig()>> lasers{
      {"urg", [] { return HokuyoConfig{}; }},
      {"sick", sick},
      {"rplidar", rplidar},
      {"lds", lds},
      {"kinect", kinect},
      {"utm", utm}};
  return lasers;
}

/// The relations between two times of a log, which may be a part of the run that they are of.
std::vector<graph::Relation> within(std::vector<graph::Relation> relations,
                                    const std::vector<io::ScanRecord>& records) {
  const auto byStamp = [](const auto& a, const auto& b) { return a.scan.stamp < b.scan.stamp; };
  const auto [first, last] = std::minmax_element(records.begin(), records.end(), byStamp);
  const double begin = first->scan.stamp - kSameMoment;
  const double end = last->scan.stamp + kSameMoment;
  const auto isOutside = [&](const graph::Relation& relation) {
    const auto [from, to] = std::minmax(relation.from_stamp, relation.to_stamp);
    return from < begin || to > end;
  };
  relations.erase(std::remove_if(relations.begin(), relations.end(), isOutside), relations.end());
  return relations;
}

}  // namespace

Recording readRecording(const std::string& name, const LogFiles& files) {
  Recording recording;
  recording.name = name;
  const auto source = io::openLog(files.log);
  while (auto record = source->next()) {
    recording.records.push_back(std::move(*record));
  }
  if (!files.relations.empty()) {
    recording.relations = within(io::readRelations(files.relations), recording.records);
  }
  if (!files.odometry.empty()) {
    recording.odometry = io::readOdometry(files.odometry);
  }
  return recording;
}

std::vector<std::string> laserNames() {
  std::vector<std::string> names;
  for (const auto& [name, make] : lasers()) {
    names.push_back(name);
  }
  return names;
}

HokuyoConfig laserNamed(const std::string& name) {
  const auto found = lasers().find(name);
  if (found == lasers().end()) {
    throw std::invalid_argument(fmt::format("There is no laser \"{}\".", name));
  }
  return found->second();
}

Recording simulateRecording(const simulation::LoadedWorld& world, const DriveSettings& settings,
                            std::uint64_t seed) {
  simulation::TurtleBotConfig robot;
  robot.seed = seed;
  robot.hokuyo = laserNamed(settings.laser);
  robot.odometry = simulation::withNoise(robot.odometry, settings.noise);
  simulation::RouteDrive drive = simulation::driveRoute(world, robot, settings.seconds);
  Recording recording;
  recording.name = world.file.map.stem().string();
  recording.truth = std::move(drive.truth);
  for (simulation::DriveScan& taken : drive.scans) {
    recording.records.push_back({std::move(taken.scan),
                                 {robot.T_base_laser, false},
                                 taken.T_odom_base,
                                 taken.motion_during_sweep});
  }
  return recording;
}

}  // namespace omega_slam::experiments

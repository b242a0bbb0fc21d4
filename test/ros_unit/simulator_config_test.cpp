#include "nodes/common/simulator_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "support/paths.h"

namespace omega_slam {
namespace {

using ::testing::UnorderedElementsAreArray;

/// Every key of a tree of parameters in the form "group/key".
std::vector<std::string> keysOf(const YAML::Node& node, const std::string& prefix = "") {
  std::vector<std::string> keys;
  for (const auto& entry : node) {
    const std::string key = prefix + entry.first.Scalar();
    if (entry.second.IsMap()) {
      const std::vector<std::string> inner = keysOf(entry.second, key + "/");
      keys.insert(keys.end(), inner.begin(), inner.end());
    } else {
      keys.push_back(key);
    }
  }
  return keys;
}

YAML::Node shipped(const std::string& name) {
  YAML::Node file = YAML::LoadFile((test::sourceFolder() / "config" / name).string());
  EXPECT_EQ(file["world"].Scalar(), "") << "a launch file says which world";
  file["world"] = "some.world.yaml";
  return file;
}

/// All that a configuration holds, in one line.
std::vector<double> numbersOf(const SimulatorConfig& config) {
  const simulation::TurtleBotConfig& robot = config.robot;
  const simulation::KobukiConfig& base = robot.kobuki;
  const simulation::OdometryConfig& odometry = robot.odometry;
  const simulation::HokuyoConfig& laser = robot.hokuyo;
  return {config.speed,
          config.start_delay,
          robot.T_base_laser.x,
          robot.T_base_laser.y,
          robot.T_base_laser.theta,
          robot.time_step,
          robot.start_time,
          static_cast<double>(robot.seed),
          base.radius,
          base.max_linear_speed,
          base.max_angular_speed,
          base.max_linear_acceleration,
          base.max_angular_acceleration,
          base.command_timeout,
          odometry.noise.rotation_per_rotation,
          odometry.noise.rotation_per_translation,
          odometry.noise.translation_per_translation,
          odometry.noise.translation_per_rotation,
          odometry.segment,
          odometry.wheel_separation,
          odometry.wheel_radius,
          laser.rate,
          static_cast<double>(laser.beams),
          laser.angle_increment,
          laser.range_min,
          laser.range_max,
          laser.dark_range,
          laser.near_accuracy,
          laser.near_limit,
          laser.far_accuracy,
          laser.accuracy_in_deviations,
          laser.no_return_is_inf ? 1.0 : 0.0};
}

std::vector<double> numbersOf(const RouteFollowerConfig& config) {
  const simulation::RouteDriverConfig& driver = config.driver;
  return {driver.max_linear_speed,
          driver.max_angular_speed,
          driver.deceleration,
          driver.corner_speed,
          driver.turn_in_place_angle,
          driver.look_ahead,
          driver.waypoint_tolerance,
          driver.stall_time,
          driver.back_off_distance,
          driver.back_off_speed,
          static_cast<double>(driver.max_bumps)};
}

/// The file holds every key, no other, and the code's defaults.
template <class Config>
void expectFileSaysTheDefaults(const std::string& name) {
  const YAML::Node file = shipped(name);
  config::ParameterReader reader(file, name);
  Config config;
  read(reader, config);
  EXPECT_NO_THROW(reader.finish());
  EXPECT_THAT(keysOf(file), UnorderedElementsAreArray(reader.knownKeys()));
  EXPECT_EQ(numbersOf(config), numbersOf(Config{}));
}

TEST(SimulatorConfig, TheShippedFileSaysTheDefaults) {
  expectFileSaysTheDefaults<SimulatorConfig>("simulator.yaml");
}

TEST(SimulatorConfig, TheShippedFileNamesTheDefaultFrames) {
  const YAML::Node file = shipped("simulator.yaml");
  const SimulatorConfig config;
  EXPECT_EQ(file["odom_frame"].Scalar(), config.odom_frame);
  EXPECT_EQ(file["base_frame"].Scalar(), config.base_frame);
  EXPECT_EQ(file["laser_frame"].Scalar(), config.laser_frame);
  EXPECT_EQ(file["bumper_frame"].Scalar(), config.bumper_frame);
  EXPECT_EQ(file["world_frame"].Scalar(), config.world_frame);
}

TEST(RouteFollowerConfig, TheShippedFileSaysTheDefaults) {
  expectFileSaysTheDefaults<RouteFollowerConfig>("route_follower.yaml");
}

/// Every number of a file, doubled, changes one number of the configuration: none is read in vain,
/// and no two into the same place.
template <class Config>
void expectEveryNumberArrives(const std::string& name) {
  const std::vector<double> defaults = numbersOf(Config{});
  for (const std::string& key : keysOf(shipped(name))) {
    YAML::Node file = YAML::Clone(shipped(name));
    const std::size_t slash = key.find('/');
    YAML::Node value =
        slash == std::string::npos ? file[key] : file[key.substr(0, slash)][key.substr(slash + 1)];
    double number = 0.0;
    const bool is_text = !value.IsScalar() || !YAML::convert<double>::decode(value, number);
    if (is_text) {
      continue;
    }
    value = number * 2.0;
    config::ParameterReader reader(file, name);
    Config config;
    read(reader, config);
    const std::vector<double> numbers = numbersOf(config);
    int changed = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      changed += numbers[i] != defaults[i] ? 1 : 0;
    }
    EXPECT_EQ(changed, 1) << key;
  }
}

TEST(SimulatorConfig, EveryNumberArrives) {
  expectEveryNumberArrives<SimulatorConfig>("simulator.yaml");
}

TEST(RouteFollowerConfig, EveryNumberArrives) {
  expectEveryNumberArrives<RouteFollowerConfig>("route_follower.yaml");
}

}  // namespace
}  // namespace omega_slam

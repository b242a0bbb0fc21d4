#include "nodes/common/simulator_config.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace omega_slam {
namespace {

constexpr config::Range kPositive{1e-6, 1e6};
constexpr config::Range kNotNegative{0.0, 1e6};

void readBase(config::ParameterReader reader, simulation::KobukiConfig& base) {
  reader.read("radius", base.radius, kPositive);
  reader.read("max_linear_speed", base.max_linear_speed, kPositive);
  reader.read("max_angular_speed", base.max_angular_speed, kPositive);
  reader.read("max_linear_acceleration", base.max_linear_acceleration, kPositive);
  reader.read("max_angular_acceleration", base.max_angular_acceleration, kPositive);
  reader.read("command_timeout", base.command_timeout, kPositive);
}

void readOdometry(config::ParameterReader reader, simulation::OdometryConfig& odometry) {
  const config::Range share{0.0, 10.0};
  reader.read("rotation_per_rotation", odometry.noise.rotation_per_rotation, share);
  reader.read("rotation_per_translation", odometry.noise.rotation_per_translation, share);
  reader.read("translation_per_translation", odometry.noise.translation_per_translation, share);
  reader.read("translation_per_rotation", odometry.noise.translation_per_rotation, share);
  reader.read("segment", odometry.segment, kPositive);
  reader.read("wheel_separation", odometry.wheel_separation, kPositive);
  reader.read("wheel_radius", odometry.wheel_radius, kPositive);
}

void readLaser(config::ParameterReader reader, simulation::HokuyoConfig& laser) {
  reader.read("rate", laser.rate, {0.1, 1000.0});
  reader.read("beams", laser.beams, {1.0, 100000.0});
  reader.read("angle_increment", laser.angle_increment, kPositive);
  reader.read("range_min", laser.range_min, kNotNegative);
  reader.read("range_max", laser.range_max, {1e-6, 1000.0});
  reader.read("dark_range", laser.dark_range, kNotNegative);
  reader.read("near_accuracy", laser.near_accuracy, kNotNegative);
  reader.read("near_limit", laser.near_limit, kNotNegative);
  reader.read("far_accuracy", laser.far_accuracy, kNotNegative);
  reader.read("accuracy_in_deviations", laser.accuracy_in_deviations, {1.0, 100.0});
  reader.read("no_return_is_inf", laser.no_return_is_inf);
}

void readLaserPose(config::ParameterReader& reader, geometry::Pose2& T_base_laser) {
  std::vector<double> pose{T_base_laser.x, T_base_laser.y, T_base_laser.theta};
  reader.read("laser_pose", pose);
  if (pose.size() == 3) {
    T_base_laser = {pose[0], pose[1], pose[2]};
  } else {
    reader.fault("laser_pose must be three numbers: x [m], y [m], yaw [rad].");
  }
}

void readWorld(config::ParameterReader& reader, std::string& world) {
  reader.read("world", world);
  if (world.empty()) {
    reader.fault("world must be the path of a world file.");
  }
}

}  // namespace

void read(config::ParameterReader& reader, SimulatorConfig& config) {
  readWorld(reader, config.world);
  int seed = 1;
  reader.read("seed", seed, {0.0, std::numeric_limits<int>::max()});
  config.robot.seed = static_cast<std::uint64_t>(seed);
  reader.read("speed", config.speed, {0.0, 1000.0});
  reader.read("start_delay", config.start_delay, {0.0, 600.0});
  reader.read("start_time", config.robot.start_time, {1e-3, 1e9});
  reader.read("time_step", config.robot.time_step, {1e-4, 1.0});
  reader.read("odom_frame", config.odom_frame);
  reader.read("base_frame", config.base_frame);
  reader.read("laser_frame", config.laser_frame);
  reader.read("bumper_frame", config.bumper_frame);
  reader.read("world_frame", config.world_frame);
  readLaserPose(reader, config.robot.T_base_laser);
  readBase(reader.group("kobuki"), config.robot.kobuki);
  readOdometry(reader.group("odometry"), config.robot.odometry);
  readLaser(reader.group("hokuyo"), config.robot.hokuyo);
  for (const std::string& violation : config.robot.validate()) {
    reader.fault(violation);
  }
}

void read(config::ParameterReader& reader, RouteFollowerConfig& config) {
  readWorld(reader, config.world);
  simulation::RouteDriverConfig& driver = config.driver;
  reader.read("max_linear_speed", driver.max_linear_speed, kPositive);
  reader.read("max_angular_speed", driver.max_angular_speed, kPositive);
  reader.read("deceleration", driver.deceleration, kPositive);
  reader.read("corner_speed", driver.corner_speed, kPositive);
  reader.read("turn_in_place_angle", driver.turn_in_place_angle, {0.01, 3.0});
  reader.read("look_ahead", driver.look_ahead, kPositive);
  reader.read("waypoint_tolerance", driver.waypoint_tolerance, kPositive);
  reader.read("stall_time", driver.stall_time, kPositive);
  reader.read("back_off_distance", driver.back_off_distance, kPositive);
  reader.read("back_off_speed", driver.back_off_speed, kPositive);
  reader.read("max_bumps", driver.max_bumps, {0.0, 1000.0});
}

}  // namespace omega_slam

#include "nodes/common/navigator_config.h"

#include "omega_slam/config/frame_name.h"
#include "omega_slam/config/slam_config.h"

namespace omega_slam {
namespace {

constexpr config::Range kLength{0.0, 100.0};  // [m]
constexpr config::Range kPositive{0.001, 1000.0};
constexpr config::Range kDuration{0.0, 3600.0};  // [s]
constexpr config::Range kPositiveDuration{0.01, 3600.0};

void readCostmap(config::ParameterReader reader, navigation::CostmapConfig& costmap) {
  reader.read("occupied_threshold", costmap.occupied_threshold, {1.0, 100.0});
  reader.read("unknown_is_free", costmap.unknown_is_free);
  reader.read("reach", costmap.reach, {0.5, 50.0});
  reader.read("memory", costmap.memory, kDuration);
  reader.read("contact_memory", costmap.contact_memory, kDuration);
}

void readPlanner(config::ParameterReader reader, navigation::PlannerConfig& planner) {
  reader.read("planner", planner.planner, navigation::plannerNames());
  reader.read("max_cells", planner.max_cells, {1.0, 1000000000.0});
  reader.read("time_limit", planner.time_limit, {0.0, 60.0});
  reader.read("iterations", planner.iterations, {1.0, 10000000.0});
  reader.read("seed", planner.seed, {1.0, 2147483647.0});
  reader.read("preferred_clearance", planner.preferred_clearance, kLength);
  reader.read("clearance_weight", planner.clearance_weight, {0.0, 100.0});
  reader.read("goal_tolerance", planner.goal_tolerance, {0.0, 10.0});
  reader.read("leave_distance", planner.leave_distance, {0.0, 10.0});
}

void readFollower(config::ParameterReader reader, navigation::FollowerConfig& follower) {
  reader.read("max_linear_speed", follower.max_linear_speed, kPositive);
  reader.read("max_angular_speed", follower.max_angular_speed, kPositive);
  reader.read("max_linear_acceleration", follower.max_linear_acceleration, kPositive);
  reader.read("max_angular_acceleration", follower.max_angular_acceleration, kPositive);
  reader.read("horizon", follower.horizon, {0.2, 10.0});
  reader.read("look_ahead", follower.look_ahead, kPositive);
  reader.read("turn_in_place_angle", follower.turn_in_place_angle, {0.3, 3.14});
  reader.read("clearance_time", follower.clearance_time, {0.0, 10.0});
  reader.read("position_tolerance", follower.position_tolerance, kPositive);
  reader.read("heading_tolerance", follower.heading_tolerance, {0.001, 3.15});
  reader.read("linear_samples", follower.linear_samples, {2.0, 100.0});
  reader.read("angular_samples", follower.angular_samples, {3.0, 100.0});
}

void readRecovery(config::ParameterReader reader, navigation::RecoveryConfig& recovery) {
  reader.read("wait", recovery.wait, kDuration);
  reader.read("back_off_distance", recovery.back_off_distance, {0.0, 10.0});
  reader.read("back_off_speed", recovery.back_off_speed, kPositive);
  reader.read("turn_speed", recovery.turn_speed, kPositive);
  reader.read("rounds", recovery.rounds, {0.0, 100.0});
}

}  // namespace

void read(config::ParameterReader& reader, NavigatorNodeConfig& config) {
  config::readFrame(reader, "map_frame", config.map_frame);
  config::readFrame(reader, "base_frame", config.base_frame);
  reader.read("control_rate", config.control_rate, {4.0, 100.0});
  reader.read("costmap_interval", config.costmap_interval, kDuration);
  reader.read("description", config.description);
  reader.read("radius", config.radius, kLength);
  navigation::NavigatorConfig& navigator = config.navigator;
  reader.read("margin", navigator.margin, {0.0, 1.0});
  reader.read("replan_interval", navigator.replan_interval, kDuration);
  reader.read("max_input_age", navigator.max_input_age, kPositiveDuration);
  reader.read("input_patience", navigator.input_patience, kDuration);
  reader.read("stall_time", navigator.stall_time, kPositiveDuration);
  reader.read("progress_time", navigator.progress_time, kPositiveDuration);
  reader.read("blocked_time", navigator.blocked_time, kDuration);
  config::readScans(reader.group("scans"), config.scans);
  readCostmap(reader.group("costmap"), navigator.costmap);
  readPlanner(reader.group("planner"), navigator.planner);
  readFollower(reader.group("follower"), navigator.follower);
  readRecovery(reader.group("recovery"), navigator.recovery);
  reader.faults(navigator.validate());
}

navigation::Footprint footprintOf(const NavigatorNodeConfig& config, const ros::NodeHandle& nh) {
  if (config.radius > 0.0) {
    return {config.radius, config.radius};
  }
  std::string urdf;
  if (!nh.getParam(config.description, urdf)) {
    throw config::ConfigurationError(
        "navigator/radius is 0, which asks for the robot's description, but there is no parameter "
        "'" +
        config.description + "'.");
  }
  return navigation::footprintFromUrdf(urdf, config.base_frame);
}

}  // namespace omega_slam

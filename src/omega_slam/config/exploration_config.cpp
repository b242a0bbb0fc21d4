#include "omega_slam/config/exploration_config.h"

#include "omega_slam/config/frame_name.h"
#include "omega_slam/exploration/strategy_factory.h"

namespace omega_slam::config {
namespace {

constexpr Range kLength{0.0, 1000.0};        // [m]
constexpr Range kDuration{0.0, 3600.0};      // [s]
constexpr Range kBudget{0.0, 1.0e6};         // [s], [m]
constexpr Range kCoordinate{-1.0e5, 1.0e5};  // [m]

}  // namespace

void read(ParameterReader& reader, FrontierExplorerNodeConfig& config) {
  exploration::ExplorerConfig& explorer = config.explorer;
  reader.read("strategy", explorer.strategy, exploration::strategyNames());
  reader.read("auto_start", config.auto_start);
  reader.read("return_home", explorer.return_home);
  reader.read("save_folder", config.save_folder);
  reader.read("time_budget", explorer.time_budget, kBudget);
  reader.read("distance_budget", explorer.distance_budget, kBudget);
  reader.read("area", explorer.area, kCoordinate);
  reader.read("robot_radius", explorer.robot_radius, {0.01, 10.0});
  reader.read("sensor_range", explorer.sensor_range, {0.1, 1000.0});
  reader.read("min_frontier", explorer.min_frontier, kLength);
  reader.read("decision_interval", explorer.decision_interval, {0.01, 3600.0});
  reader.read("settle_time", explorer.settle_time, kDuration);
  reader.read("set_aside_time", explorer.set_aside_time, kDuration);
  reader.read("give_up_time", explorer.give_up_time, {0.1, 3600.0});
  reader.read("max_attempts", explorer.max_attempts, {1.0, 100.0});
  reader.read("max_failures", explorer.max_failures, {1.0, 1000.0});
  reader.read("switch_probability", explorer.switch_probability, {0.0, 1.0});
  reader.read("seed", explorer.seed, {0.0});
  reader.read("update_rate", config.update_rate, {0.1, 100.0});
  readFrame(reader, "map_frame", config.map_frame);
  readFrame(reader, "base_frame", config.base_frame);
  reader.faults(explorer.validate());
}

}  // namespace omega_slam::config

#include "omega_slam/exploration/explorer_config.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/exploration/strategy_factory.h"

namespace omega_slam::exploration {

std::vector<std::string> ExplorerConfig::validate() const {
  std::vector<std::string> violations;
  const auto require = [&violations](bool holds, const char* sentence) {
    if (!holds) {
      violations.emplace_back(sentence);
    }
  };
  const auto& names = strategyNames();
  require(std::find(names.begin(), names.end(), strategy) != names.end(),
          "strategy must be one that exists.");
  require(robot_radius > 0.0 && robot_radius <= 10.0, "robot_radius must be in (0, 10] m.");
  require(sensor_range > 0.0 && sensor_range <= 1000.0, "sensor_range must be in (0, 1000] m.");
  require(min_frontier >= 0.0 && std::isfinite(min_frontier), "min_frontier must be 0 or more.");
  require(decision_interval > 0.0, "decision_interval must be above 0.");
  require(settle_time >= 0.0, "settle_time must be 0 or more.");
  require(set_aside_time >= 0.0, "set_aside_time must be 0 or more.");
  require(give_up_time > 0.0, "give_up_time must be above 0.");
  require(max_attempts >= 1, "max_attempts must be 1 or more.");
  require(max_failures >= 1, "max_failures must be 1 or more.");
  require(time_budget >= 0.0, "time_budget must be 0 or more.");
  require(distance_budget >= 0.0, "distance_budget must be 0 or more.");
  require(area.empty() || (area.size() >= 6 && area.size() % 2 == 0),
          "area must be empty, or x and y of three corners or more.");
  require(std::all_of(area.begin(), area.end(), [](double value) { return std::isfinite(value); }),
          "area must be finite.");
  require(switch_probability >= 0.0 && switch_probability <= 1.0,
          "switch_probability must be in [0, 1].");
  return violations;
}

}  // namespace omega_slam::exploration

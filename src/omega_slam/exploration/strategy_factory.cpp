#include "omega_slam/exploration/strategy_factory.h"

#include <stdexcept>

#include "omega_slam/exploration/along_route.h"
#include "omega_slam/exploration/gain_over_cost.h"
#include "omega_slam/exploration/nearest_to_origin.h"
#include "omega_slam/exploration/nearest_to_robot.h"
#include "omega_slam/exploration/tour.h"

namespace omega_slam::exploration {

const std::vector<std::string>& strategyNames() {
  static const std::vector<std::string> names{
      "nearest_to_robot", "nearest_to_origin", "along_route", "gain_over_cost", "tour",
      kWallFollowing};
  return names;
}

std::unique_ptr<const Strategy> makeStrategy(const std::string& name) {
  if (name == "nearest_to_robot") {
    return std::make_unique<NearestToRobot>();
  }
  if (name == "nearest_to_origin") {
    return std::make_unique<NearestToOrigin>();
  }
  if (name == "along_route") {
    return std::make_unique<AlongRoute>();
  }
  if (name == "gain_over_cost") {
    return std::make_unique<GainOverCost>();
  }
  if (name == "tour") {
    return std::make_unique<Tour>();
  }
  if (name == kWallFollowing) {
    return nullptr;
  }
  throw std::invalid_argument("There is no strategy \"" + name + "\".");
}

}  // namespace omega_slam::exploration

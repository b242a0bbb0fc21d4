#include "omega_slam/exploration/nearest_to_robot.h"

namespace omega_slam::exploration {

std::size_t NearestToRobot::choose(const Situation& situation) const {
  return cheapest(situation.options, [](const Option& option) { return option.viewpoint.travel; });
}

}  // namespace omega_slam::exploration

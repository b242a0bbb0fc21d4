#include "omega_slam/exploration/gain_over_cost.h"

namespace omega_slam::exploration {

std::size_t GainOverCost::choose(const Situation& situation) const {
  constexpr double kTurnCost = 0.3;   // [m/rad] about what the robot drives while it turns so far
  constexpr double kLeastCost = 0.5;  // [m] no frontier is so near that nothing else matters
  return cheapest(situation.options, [](const Option& option) {
    return -option.gain / (kLeastCost + option.viewpoint.travel + kTurnCost * option.turn);
  });
}

}  // namespace omega_slam::exploration

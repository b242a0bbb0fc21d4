#include "omega_slam/exploration/along_route.h"

#include <cmath>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::exploration {

std::size_t AlongRoute::choose(const Situation& situation) const {
  constexpr double kSameDirection = geometry::kPi / 4.0;  // [rad]
  constexpr double kFar = 1.0e6;                          // [m] longer than any way
  return cheapest(situation.options, [](const Option& option) {
    return std::floor(option.turn / kSameDirection) * kFar + option.viewpoint.travel;
  });
}

}  // namespace omega_slam::exploration

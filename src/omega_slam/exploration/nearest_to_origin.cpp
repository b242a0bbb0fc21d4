#include "omega_slam/exploration/nearest_to_origin.h"

namespace omega_slam::exploration {

std::size_t NearestToOrigin::choose(const Situation& situation) const {
  return cheapest(situation.options, [&situation](const Option& option) {
    return (option.viewpoint.T_map_base.translation() - situation.origin).norm();
  });
}

}  // namespace omega_slam::exploration

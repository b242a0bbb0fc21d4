#pragma once

#include "omega_slam/exploration/strategy.h"

namespace omega_slam::exploration {

/// The next frontier in the current route (the paper, section 4.3): not the closest, but one in the
/// direction of travel, for fewer turns and more straight motion. Ways that begin within the same
/// eighth of a turn are as good as each other; among them the shortest is taken.
class AlongRoute : public Strategy {
 public:
  [[nodiscard]] std::size_t choose(const Situation& situation) const override;
};

}  // namespace omega_slam::exploration

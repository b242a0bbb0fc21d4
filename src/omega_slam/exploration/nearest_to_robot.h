#pragma once

#include "omega_slam/exploration/strategy.h"

namespace omega_slam::exploration {

/// The frontier closest to the robot (the paper, section 4.3), by the length of the way to it.
class NearestToRobot : public Strategy {
 public:
  [[nodiscard]] std::size_t choose(const Situation& situation) const override;
};

}  // namespace omega_slam::exploration

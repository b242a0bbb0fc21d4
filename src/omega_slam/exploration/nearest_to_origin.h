#pragma once

#include "omega_slam/exploration/strategy.h"

namespace omega_slam::exploration {

/// The frontier closest to where the robot began (the paper, section 4.3): the known area grows
/// like a circle, and the robot passes again and again through what it knows, which is good for
/// loops. As in the paper the distance is as the crow flies.
class NearestToOrigin : public Strategy {
 public:
  [[nodiscard]] std::size_t choose(const Situation& situation) const override;
};

}  // namespace omega_slam::exploration

#pragma once

#include "omega_slam/exploration/strategy.h"

namespace omega_slam::exploration {

/// Most unknown area for the way: information gain over travel cost (Gonzalez-Banos and Latombe,
/// "Navigation Strategies for Exploring Indoor Environments", IJRR 21, 2002, who weigh the gain by
/// the exponential of the way; a quotient has no parameter to tune). The cost of turning towards it
/// counts as way.
class GainOverCost : public Strategy {
 public:
  [[nodiscard]] std::size_t choose(const Situation& situation) const override;
};

}  // namespace omega_slam::exploration

#pragma once

#include "omega_slam/exploration/frontier.h"

namespace omega_slam::exploration {

/// Whether a round robot could come up to a frontier: from a free place beside one of its cells and
/// in sight of it, where no obstacle would be touched. Unknown cells are none here, lest a door
/// that is half seen is taken for a gap. Where it could not, the frontier lies within a gap that no
/// robot fits into, and is seen only from outside.
/// @param radius [m] of the robot
[[nodiscard]] bool canComeUpTo(const Frontier& frontier, const MapView& map, double radius);

}  // namespace omega_slam::exploration

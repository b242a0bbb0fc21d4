#pragma once

#include <memory>
#include <string>
#include <vector>

#include "omega_slam/exploration/strategy.h"

namespace omega_slam::exploration {

/// The strategy that looks at no frontiers; it is no Strategy, see WallFollower.
inline constexpr const char* kWallFollowing = "wall_following";

/// All that can be asked for, wall following included.
[[nodiscard]] const std::vector<std::string>& strategyNames();

/// @return null for wall following; @throws std::invalid_argument for a name that does not exist
[[nodiscard]] std::unique_ptr<const Strategy> makeStrategy(const std::string& name);

}  // namespace omega_slam::exploration

#pragma once

#include <omega_slam/ExplorationStatus.h>

#include <string>

namespace omega_slam {

/// What an exploration is at, for a line of status and for the end of a run: "exploring, 42 %
/// known", "explored" once it has ended, or "stuck: why".
[[nodiscard]] std::string explorationLine(const ExplorationStatus& status);

}  // namespace omega_slam

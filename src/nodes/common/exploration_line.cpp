#include "nodes/common/exploration_line.h"

#include <fmt/format.h>

namespace omega_slam {

std::string explorationLine(const ExplorationStatus& status) {
  if (status.phase != "ended") {
    return fmt::format("{}, {:.0f} % known", status.phase, 100.0 * status.share);
  }
  return status.ending == "stuck" ? "stuck: " + status.reason : "explored";
}

}  // namespace omega_slam

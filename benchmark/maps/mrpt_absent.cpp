#include "maps/standing_scans.h"

namespace omega_slam::experiments {

std::optional<TimedMap> drawByMrpt(const std::vector<StandingScan>&, const sensing::LaserMount&,
                                   const grid::GridGeometry&) {
  return std::nullopt;
}

}  // namespace omega_slam::experiments

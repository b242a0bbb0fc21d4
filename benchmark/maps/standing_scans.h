#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "maps/survey.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/sensing/laser_scan.h"

namespace omega_slam::experiments {

/// A scan taken standing still: without motion during the sweep every program reads it alike.
struct StandingScan {
  sensing::LaserScan scan;
  geometry::Pose2 T_map_base;  ///< true
};

/// Scans with noise, as many as asked for, evenly along a site's route.
[[nodiscard]] std::vector<StandingScan> takeStandingScans(const Site& site, std::size_t count,
                                                          std::uint64_t seed);

/// A map and what it took.
struct TimedMap {
  grid::OccupancyGrid map;
  double seconds{0.0};  ///< of processor time for all scans
};

/// By MRPT's occupancy grid: beams, log-odds, its defaults but that beams without a return say
/// nothing, as with us. Nothing if MRPT was not found when this was built.
/// @param area where the map is to lie
[[nodiscard]] std::optional<TimedMap> drawByMrpt(const std::vector<StandingScan>& scans,
                                                 const sensing::LaserMount& mount,
                                                 const grid::GridGeometry& area);

}  // namespace omega_slam::experiments

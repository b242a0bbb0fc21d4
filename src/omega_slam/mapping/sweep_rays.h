#pragma once

#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/mapping/tile.h"
#include "omega_slam/sensing/sweep.h"

namespace omega_slam::mapping {

/// A beam of a sweep as it is drawn.
struct Ray {
  Eigen::Vector2d end{0.0, 0.0};  ///< [cells] from the origin of the map
  double length{0.0};             ///< [cells]
  bool is_hit{false};             ///< whether an obstacle is at the end
  std::size_t beam{0};            ///< its place in the sweep: neighbours differ by 1
};

/// The beams of a sweep that say something, in cells of a map.
struct SweepRays {
  Eigen::Vector2d start{0.0, 0.0};  ///< [cells] the laser
  double resolution{0.0};           ///< [m] edge of a cell
  double angle_increment{0.0};      ///< [rad] between neighbouring beams of the sweep
  std::vector<Ray> rays;            ///< in the order of the sweep
  CellBox box;                      ///< around start and ends; empty if there are no rays
};

/// Places a sweep in the map. Beams of unknown kind are left out. Beams longer than `max_range` are
/// cut there and hit nothing.
/// @param max_range [m]; 0: no limit
/// @param rays is overwritten
/// @return an empty string, or why the sweep can't be drawn: a pose or a beam that is not finite, a
/// place so far from the origin that the numbers of cells would not fit into an int
[[nodiscard]] std::string placeRays(const sensing::Sweep& sweep, const geometry::Pose2& T_map_base,
                                    double resolution, double max_range, SweepRays& rays);

}  // namespace omega_slam::mapping

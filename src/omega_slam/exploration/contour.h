#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "omega_slam/exploration/map_view.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/sweep.h"

namespace omega_slam::exploration {

/// The cells along the outline of what a sweep has seen, and those around them; with the box around
/// all that it can have touched.
struct Contour {
  std::vector<Cell> cells;      ///< each once
  Eigen::AlignedBox2i touched;  ///< both corners inclusive
};

/// The outline goes from beam's end to beam's end, and back to the laser where beams say nothing,
/// as they do behind it.
/// @param margin cells on either side of the outline; 1 is enough if the map was drawn with exactly
/// this pose
/// @return empty if the pose is not finite or no beam says anything
[[nodiscard]] Contour contourOf(const sensing::Sweep& sweep, const geometry::Pose2& T_map_base,
                                const MapView& map, int margin);

}  // namespace omega_slam::exploration

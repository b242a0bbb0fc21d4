#pragma once

#include <Eigen/Core>

#include "omega_slam/exploration/map_view.h"

namespace omega_slam::exploration {

/// [m^2] of unknown area that a laser would see from a place, if all that is unknown were open:
/// rays go on through the unknown until they meet an obstacle or end.
/// @param position [m] map frame; @param range [m]
[[nodiscard]] double expectedGain(const MapView& map, const Eigen::Vector2d& position,
                                  double range);

}  // namespace omega_slam::exploration

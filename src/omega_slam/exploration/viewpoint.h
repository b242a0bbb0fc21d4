#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "omega_slam/exploration/frontier.h"
#include "omega_slam/exploration/travel_field.h"
#include "omega_slam/geometry/pose2.h"

namespace omega_slam::exploration {

/// A place from which a frontier is to be looked at.
struct Viewpoint {
  geometry::Pose2 T_map_base;  ///< looks at the frontier's centroid
  double travel{0.0};          ///< [m] from the start of the travel field
};

/// The place that the robot can reach from which a cell of the frontier is seen from nearest by,
/// measured through open cells; where two are as near, the one nearer to the centroid.
/// @param tried [m] places from which looking has not helped: new ones keep away from them
/// @param reach [m] how far away from the frontier to look for one
[[nodiscard]] std::optional<Viewpoint> findViewpoint(const Frontier& frontier, const MapView& map,
                                                     const TravelField& travel,
                                                     const std::vector<Eigen::Vector2d>& tried,
                                                     double reach);

/// Whether the first cell and all between the two are free.
[[nodiscard]] bool isInSight(const MapView& map, const Cell& from, const Cell& to);

}  // namespace omega_slam::exploration

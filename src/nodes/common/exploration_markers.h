#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "omega_slam/exploration/explorer.h"

namespace omega_slam {

/// An exploration for rviz: the cells of each frontier in a colour of its own, centroids, the goal,
/// and what is set aside with the number of attempts. Each kind has a namespace of its own, to be
/// switched on and off.
[[nodiscard]] visualization_msgs::MarkerArray explorationMarkers(
    const exploration::Explorer& explorer, const exploration::MapView& map,
    const std_msgs::Header& header);

}  // namespace omega_slam

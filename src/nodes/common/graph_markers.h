#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam {

/// The graph for rviz: a dot for each keyframe, a line for each constraint, coloured by its kind.
/// Each kind has a namespace of its own, to be switched on and off.
[[nodiscard]] visualization_msgs::MarkerArray graphMarkers(const graph::PoseGraph& graph,
                                                           const std_msgs::Header& header);

}  // namespace omega_slam

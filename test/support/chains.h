#pragma once

#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::test {

/// A graph of nodes that are tied one to the next, each by where it is.
/// @param deviation [m], [rad] of each tie
[[nodiscard]] graph::PoseGraph chainOf(const std::vector<geometry::Pose2>& poses, double deviation);

}  // namespace omega_slam::test

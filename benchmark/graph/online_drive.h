#pragma once

#include <string>
#include <vector>

#include "graph/contestants.h"
#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::experiments {

/// A graph that came pose by pose.
struct OnlineDrive {
  std::vector<double> seconds;  ///< of each update; the last one ends in a solve of the whole
  Solution solution;
};

/// Plays a graph to graph::IncrementalSolver, by its defaults, without kernels. A pose comes with
/// all constraints to poses before it, its guess by the one to the latest of these.
[[nodiscard]] OnlineDrive playOnline(const graph::PoseGraph& graph);

/// The table of a drive: pose, microseconds.
[[nodiscard]] std::string updateTable(const OnlineDrive& drive);

}  // namespace omega_slam::experiments

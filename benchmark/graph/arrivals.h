#pragma once

#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::experiments {

/// What comes with a node when a graph is played node by node: its constraints to nodes before it.
struct Arrival {
  std::vector<graph::Constraint> ties;   ///< the one to the latest of these, if there is any
  std::vector<graph::Constraint> loops;  ///< the others, those to later nodes first
};

/// Of each node.
[[nodiscard]] std::vector<Arrival> arrivalsOf(const graph::PoseGraph& graph);

}  // namespace omega_slam::experiments

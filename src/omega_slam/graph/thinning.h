#pragma once

#include <string>
#include <vector>

#include "omega_slam/graph/node_removal.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/retired_nodes.h"
#include "omega_slam/graph/weighing.h"

namespace omega_slam::graph {

struct ThinningConfig {
  double spacing{0.5};           ///< [m] nodes nearer than this,
  double turn{0.5};              ///< [rad] and with headings nearer than this, are of one place
  int nodes_per_place{3};        ///< the newest of a place, which stay; 0: all do
  int newest{50};                ///< nodes that stay in any case: the robot is among them
  double max_divergence{1.0};    ///< [nats] of each removal
  KernelConfig kernels{kPlain};  ///< what the constraints count

  [[nodiscard]] std::vector<std::string> validate() const;
};

struct ThinningReport {
  std::vector<NodeId> kept;  ///< which node each of those left was
  double divergence{0.0};    ///< [nats] sum of what was lost
};

/// Removes nodes from places that have many, the oldest first, so that a graph grows with the area
/// that is driven and not with the time. Node 0 stays: the map hangs on it.
/// @throws std::invalid_argument for a faulty configuration
ThinningReport thinOut(PoseGraph& graph, const ThinningConfig& config = {});

/// Whether any place has so many nodes that some may go; else retireNodes() does nothing.
[[nodiscard]] bool isAnyCrowded(const PoseGraph& graph, const ThinningConfig& config);

/// The same as thinOut() by retireNode(): nodes keep their numbers.
std::vector<Retirement> retireNodes(PoseGraph& graph, const ThinningConfig& config = {});

}  // namespace omega_slam::graph

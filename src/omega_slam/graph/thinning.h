#pragma once

#include <optional>
#include <string>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// Takes a node out of a graph, and replaces what it said of its neighbours.
///
/// Marginalised exactly, a node leaves all its neighbours tied to each other, and Omega fills up.
/// Of these ties only a tree is kept, the one that loses least: a constraint for each of its edges,
/// with the relative pose's exact mean and covariance, has the least Kullback-Leibler divergence
/// from the exact marginal of all trees (Chow and Liu 1968; Kretzschmar and Stachniss,
/// "Information-theoretic compression of pose graphs for laser-based SLAM", IJRR 2012; in closed
/// form: Mazuran, Burgard and Tipaldi, "Nonlinear factor recovery for long-term SLAM", IJRR 2016).
/// A node on a chain, and a leaf, lose nothing.
///
/// @param graph at its solution, which is where constraints are linearised. Indices of later nodes
/// move down by one.
/// @param max_divergence [nats] what may be lost at most
/// @return what was lost; none, and the graph as it was, where that is too much, the node is held
/// or a point, sees a point, or holds the graph together in a way that its constraints do not
/// determine
std::optional<double> removeNode(PoseGraph& graph, NodeId node, double max_divergence);

struct ThinningConfig {
  double spacing{0.5};         ///< [m] nodes nearer than this,
  double turn{0.5};            ///< [rad] and with headings nearer than this, are of one place
  int nodes_per_place{3};      ///< the newest of a place, which stay
  int newest{50};              ///< nodes that stay in any case: the robot is among them
  double max_divergence{1.0};  ///< [nats] of each removal

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

}  // namespace omega_slam::graph

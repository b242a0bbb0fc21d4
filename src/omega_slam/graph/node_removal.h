#pragma once

#include <optional>
#include <vector>

#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/retired_nodes.h"
#include "omega_slam/graph/weighing.h"

namespace omega_slam::graph {

/// Every constraint counts in full.
inline const KernelConfig kPlain{{KernelKind::kNone, 1.0},
                                 {KernelKind::kNone, 1.0},
                                 {KernelKind::kNone, 1.0},
                                 {KernelKind::kNone, 1.0}};

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
/// @param kernels what the constraints count
std::optional<double> removeNode(PoseGraph& graph, NodeId node, double max_divergence,
                                 const KernelConfig& kernels = kPlain);

/// The same, but the node stays under its number, held and without constraints, and later ones do
/// not move down. Its anchor is the nearest of those that it was tied to.
std::optional<Retirement> retireNode(PoseGraph& graph, NodeId node, double max_divergence,
                                     const KernelConfig& kernels = kPlain);

/// Takes out nodes that no constraint is tied to. Indices of later ones move down.
void eraseNodes(PoseGraph& graph, const std::vector<NodeId>& nodes);

}  // namespace omega_slam::graph

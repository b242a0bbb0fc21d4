#pragma once

#include <cstddef>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// Trees in which every node hangs on an earlier one of `order` by a constraint; roots hang on
/// nothing. Roots are the held nodes of the graph, and one node, the lowest, of each part in which
/// none is held: those that a solver must not move, since nothing says where they lie.
struct SpanningForest {
  std::vector<NodeId> roots;
  std::vector<NodeId> order;               ///< all nodes, each after what it hangs on
  std::vector<std::size_t> by_constraint;  ///< by node; kRoot for roots

  static constexpr std::size_t kRoot = static_cast<std::size_t>(-1);
};

/// Which way trees grow.
enum class Growth {
  kFewest,  ///< breadth first: every node as few constraints away from a root as can be
  kChain    ///< from each node to the next one or the one before, as long as that goes on
};

/// O(constraints)
[[nodiscard]] SpanningForest spanningForest(const PoseGraph& graph,
                                            Growth growth = Growth::kFewest);

/// The pose at which a tree puts a node, given that of the node that it hangs on; a root's own.
[[nodiscard]] geometry::Pose2 poseByTree(const PoseGraph& graph, const SpanningForest& forest,
                                         NodeId node);

}  // namespace omega_slam::graph

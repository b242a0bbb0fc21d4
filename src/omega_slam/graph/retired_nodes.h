#pragma once

#include <cstddef>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// A node that was taken out of a graph, and what it goes with from then on.
struct Retirement {
  NodeId node{0};
  NodeId anchor{0};
  geometry::Pose2 T_anchor_node;
  double divergence{0.0};  ///< [nats] what was lost
};

/// Nodes that are not estimated any more, but keep their numbers and a pose: each goes with its
/// anchor, a node that is estimated, like two parts of one body. How well their relative pose was
/// known is forgotten.
class RetiredNodes {
 public:
  /// Nodes that went with `retirement.node` go with its anchor from now on.
  void add(const Retirement& retirement);

  [[nodiscard]] std::size_t size() const { return anchorings_.size(); }
  [[nodiscard]] bool has(NodeId node) const { return find(node) != nullptr; }

  /// What a constraint says of the nodes that are estimated. It may tie one to itself then, and
  /// says nothing.
  [[nodiscard]] Constraint carried(const Constraint& constraint) const;

  /// Calls `move(node, T_map_node)` for each, with the pose that its anchor's asks for.
  template <typename Move>
  void follow(const std::vector<geometry::Pose2>& poses, Move move) const {
    for (const Anchoring& anchoring : anchorings_) {
      move(anchoring.node, poses[anchoring.anchor] * anchoring.T_anchor_node);
    }
  }

 private:
  struct Anchoring {
    NodeId node;
    NodeId anchor;
    geometry::Pose2 T_anchor_node;
  };
  [[nodiscard]] const Anchoring* find(NodeId node) const;

  std::vector<Anchoring> anchorings_;  ///< by node, ascending
};

}  // namespace omega_slam::graph

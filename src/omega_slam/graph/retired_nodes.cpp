#include "omega_slam/graph/retired_nodes.h"

#include "omega_slam/geometry/covariance.h"

namespace omega_slam::graph {

using geometry::Pose2;

void RetiredNodes::add(const Retirement& retirement) {
  for (auto& [node, anchoring] : anchorings_) {
    if (anchoring.anchor == retirement.node) {
      anchoring = {retirement.anchor, retirement.T_anchor_node * anchoring.T_anchor_node};
    }
  }
  anchorings_[retirement.node] = {retirement.anchor, retirement.T_anchor_node};
}

Constraint RetiredNodes::carried(const Constraint& constraint) const {
  Constraint result = constraint;
  if (const auto from = anchorings_.find(constraint.from); from != anchorings_.end()) {
    result.from = from->second.anchor;
    result.T_from_to = from->second.T_anchor_node * result.T_from_to;
  }
  if (const auto to = anchorings_.find(constraint.to); to != anchorings_.end()) {
    const Pose2 T_node_anchor = to->second.T_anchor_node.inverse();
    result.to = to->second.anchor;
    result.T_from_to = result.T_from_to * T_node_anchor;
    // The error was a motion of the node, and is one of its anchor now.
    const Eigen::Matrix3d along = geometry::adjoint(T_node_anchor);
    result.information = along.transpose() * result.information * along;
  }
  return result;
}

}  // namespace omega_slam::graph

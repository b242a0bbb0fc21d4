#include "omega_slam/graph/retired_nodes.h"

#include <algorithm>

#include "omega_slam/geometry/covariance.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

template <typename Anchoring>
bool isBefore(const Anchoring& anchoring, NodeId node) {
  return anchoring.node < node;
}

}  // namespace

void RetiredNodes::add(const Retirement& retirement) {
  for (Anchoring& anchoring : anchorings_) {
    if (anchoring.anchor == retirement.node) {
      anchoring.anchor = retirement.anchor;
      anchoring.T_anchor_node = retirement.T_anchor_node * anchoring.T_anchor_node;
    }
  }
  const auto place = std::lower_bound(anchorings_.begin(), anchorings_.end(), retirement.node,
                                      isBefore<Anchoring>);
  anchorings_.insert(place, {retirement.node, retirement.anchor, retirement.T_anchor_node});
}

const RetiredNodes::Anchoring* RetiredNodes::find(NodeId node) const {
  const auto place =
      std::lower_bound(anchorings_.begin(), anchorings_.end(), node, isBefore<Anchoring>);
  return place != anchorings_.end() && place->node == node ? &*place : nullptr;
}

Constraint RetiredNodes::carried(const Constraint& constraint) const {
  Constraint result = constraint;
  if (const Anchoring* from = find(constraint.from)) {
    result.from = from->anchor;
    result.T_from_to = from->T_anchor_node * result.T_from_to;
  }
  if (const Anchoring* to = find(constraint.to)) {
    const Pose2 T_node_anchor = to->T_anchor_node.inverse();
    result.to = to->anchor;
    result.T_from_to = result.T_from_to * T_node_anchor;
    // The error was a motion of the node, and is one of its anchor now.
    const Eigen::Matrix3d along = geometry::adjoint(T_node_anchor);
    result.information = along.transpose() * result.information * along;
  }
  return result;
}

}  // namespace omega_slam::graph

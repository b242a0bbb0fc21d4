#include "omega_slam/graph/estimated_part.h"

namespace omega_slam::graph {

EstimatedPart::EstimatedPart(const PoseGraph& whole) {
  std::vector<bool> is_idle(whole.poses.size(), false);
  for (const NodeId node : whole.held) {
    is_idle[node] = true;
  }
  for (const Constraint& constraint : whole.constraints) {
    is_idle[constraint.from] = is_idle[constraint.to] = false;
  }
  for (NodeId node = 0; node < whole.poses.size(); ++node) {
    if (!is_idle[node]) {
      append(node);
    }
  }
}

Constraint EstimatedPart::renumbered(const Constraint& constraint) const {
  Constraint result = constraint;
  result.from = numbers_[constraint.from];
  result.to = numbers_[constraint.to];
  return result;
}

PoseGraph EstimatedPart::of(const PoseGraph& whole) const {
  PoseGraph part;
  part.poses.reserve(nodes_.size());
  for (const NodeId node : nodes_) {
    part.poses.push_back(whole.poses[node]);
  }
  part.constraints.reserve(whole.constraints.size());
  for (const Constraint& constraint : whole.constraints) {
    part.constraints.push_back(renumbered(constraint));
  }
  const auto pick = [this](const std::vector<NodeId>& from, std::vector<NodeId>& to) {
    for (const NodeId node : from) {
      if (has(node)) {
        to.push_back(numbers_[node]);
      }
    }
  };
  pick(whole.held, part.held);
  pick(whole.points, part.points);
  return part;
}

void EstimatedPart::append(NodeId node) {
  numbers_.resize(node + std::size_t{1}, kNone);
  numbers_[node] = static_cast<NodeId>(nodes_.size());
  nodes_.push_back(node);
}

void EstimatedPart::place(const std::vector<geometry::Pose2>& poses, PoseGraph& whole) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    whole.poses[nodes_[i]] = poses[i];
  }
}

}  // namespace omega_slam::graph

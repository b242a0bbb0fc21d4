#include "omega_slam/graph/topology.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "omega_slam/graph/constraints_by_node.h"

namespace omega_slam::graph {

namespace {

/// Grows trees from a root until nothing more can be reached.
class Grower {
 public:
  Grower(const PoseGraph& graph, Growth growth)
      : graph_(graph), growth_(growth), touching_(graph), is_reached_(graph.poses.size(), false) {
    forest_.order.reserve(graph.poses.size());
    forest_.by_constraint.assign(graph.poses.size(), SpanningForest::kRoot);
  }

  [[nodiscard]] bool isReached(NodeId node) const { return is_reached_[node]; }

  void plant(NodeId root) {
    is_reached_[root] = true;
    forest_.roots.push_back(root);
    forest_.order.push_back(root);
    reachFrom(root);
  }

  void grow() {
    while (!waiting_.empty()) {
      const Branch branch = waiting_.front();
      waiting_.pop_front();
      if (!is_reached_[branch.node]) {
        is_reached_[branch.node] = true;
        forest_.by_constraint[branch.node] = branch.by_constraint;
        forest_.order.push_back(branch.node);
        reachFrom(branch.node);
      }
    }
  }

  [[nodiscard]] SpanningForest take() { return std::move(forest_); }

 private:
  struct Branch {
    NodeId node;
    std::size_t by_constraint;
  };

  void reachFrom(NodeId node) {
    touching_.forEach(node, [&](std::size_t k) {
      const Constraint& constraint = graph_.constraints[k];
      const NodeId other = constraint.from == node ? constraint.to : constraint.from;
      const auto [low, high] = std::minmax(node, other);
      if (is_reached_[other]) {
        return;
      }
      if (growth_ == Growth::kChain && high - low == 1) {
        waiting_.push_front({other, k});
      } else {
        waiting_.push_back({other, k});
      }
    });
  }

  const PoseGraph& graph_;
  Growth growth_;
  ConstraintsByNode touching_;
  std::vector<bool> is_reached_;
  std::deque<Branch> waiting_;
  SpanningForest forest_;
};

}  // namespace

SpanningForest spanningForest(const PoseGraph& graph, Growth growth) {
  Grower grower(graph, growth);
  for (const NodeId node : graph.held) {
    if (!grower.isReached(node)) {
      grower.plant(node);
    }
  }
  grower.grow();
  for (std::size_t node = 0; node < graph.poses.size(); ++node) {
    if (!grower.isReached(static_cast<NodeId>(node))) {
      grower.plant(static_cast<NodeId>(node));
      grower.grow();
    }
  }
  return grower.take();
}

geometry::Pose2 poseByTree(const PoseGraph& graph, const SpanningForest& forest, NodeId node) {
  const std::size_t k = forest.by_constraint[node];
  if (k == SpanningForest::kRoot) {
    return graph.poses[node];
  }
  const Constraint& constraint = graph.constraints[k];
  return constraint.to == node ? graph.poses[constraint.from] * constraint.T_from_to
                               : graph.poses[constraint.to] * constraint.T_from_to.inverse();
}

}  // namespace omega_slam::graph

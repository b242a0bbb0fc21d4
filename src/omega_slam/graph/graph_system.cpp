#include "omega_slam/graph/graph_system.h"

namespace omega_slam::graph {

void GraphSystem::prepare(const PoseGraph& graph, const std::vector<NodeId>& held) {
  std::vector<std::pair<NodeId, NodeId>> ties;
  ties.reserve(graph.constraints.size());
  for (const Constraint& constraint : graph.constraints) {
    ties.emplace_back(constraint.from, constraint.to);
  }
  factorizations_ = 0;
  if (form_ && nodes_ == graph.poses.size() && ties == ties_ && held == held_) {
    return;
  }
  ties_ = std::move(ties);
  held_ = held;
  nodes_ = graph.poses.size();
  form_.emplace(nodes_, graph.constraints, held_);
  cholesky_ = std::make_unique<SparseCholesky>(*form_);
}

std::optional<Eigen::VectorXd> GraphSystem::solve() {
  ++factorizations_;
  if (!cholesky_->factorize(*form_)) {
    return std::nullopt;
  }
  Eigen::VectorXd mu = cholesky_->solve(form_->xi());
  if (!mu.allFinite()) {
    return std::nullopt;
  }
  return mu;
}

}  // namespace omega_slam::graph

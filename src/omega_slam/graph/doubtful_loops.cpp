#include "omega_slam/graph/doubtful_loops.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace omega_slam::graph {
namespace {

/// Which nodes hang together.
class Parts {
 public:
  explicit Parts(std::size_t nodes) : parents_(nodes) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }

  /// @return whether they were apart
  bool unite(std::size_t a, std::size_t b) {
    const std::size_t root_a = rootOf(a);
    const std::size_t root_b = rootOf(b);
    parents_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    return root_a != root_b;
  }

 private:
  std::size_t rootOf(std::size_t node) {
    while (parents_[node] != node) {
      node = parents_[node] = parents_[parents_[node]];
    }
    return node;
  }

  std::vector<std::size_t> parents_;
};

/// Nodes that lie somewhere, or hang together, without any loop.
Parts partsWithoutLoops(const PoseGraph& graph) {
  Parts parts(graph.poses.size());
  for (const Constraint& constraint : graph.constraints) {
    if (constraint.kind != ConstraintKind::kLoop) {
      parts.unite(constraint.from, constraint.to);
    }
  }
  for (const NodeId node : graph.held) {
    parts.unite(graph.held.front(), node);
  }
  return parts;
}

void findTies(const PoseGraph& graph, std::vector<DoubtfulLoop>& loops) {
  std::vector<DoubtfulLoop*> order;
  for (DoubtfulLoop& loop : loops) {
    order.push_back(&loop);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
    return std::pair(a->is_presumed, a->supporters.size()) >
           std::pair(b->is_presumed, b->supporters.size());
  });
  Parts parts = partsWithoutLoops(graph);
  for (DoubtfulLoop* loop : order) {
    const Constraint& constraint = graph.constraints[loop->constraint];
    loop->is_tie = parts.unite(constraint.from, constraint.to);
    loop->is_believed = loop->is_tie || loop->is_presumed;
  }
}

/// What agrees with a loop in question is in question, too: they stand or fall together.
void presume(const std::vector<bool>& settled, std::vector<DoubtfulLoop>& loops) {
  const auto isSettled = [&](std::size_t i) { return settled[loops[i].constraint]; };
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const std::vector<std::size_t>& supporters = loops[i].supporters;
    loops[i].is_presumed =
        isSettled(i) && std::all_of(supporters.begin(), supporters.end(), isSettled);
  }
}

}  // namespace

std::vector<DoubtfulLoop> doubtfulLoops(const PoseGraph& graph, const SupportConfig& config,
                                        const std::vector<bool>& settled) {
  std::vector<std::size_t> indices;
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    if (graph.constraints[k].kind == ConstraintKind::kLoop) {
      indices.push_back(k);
    }
  }
  auto agreeing = agreeingLoops(graph, indices, config);
  std::vector<DoubtfulLoop> loops(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    loops[i].constraint = indices[i];
    loops[i].supporters = std::move(agreeing[i]);
  }
  if (!settled.empty()) {
    presume(settled, loops);
  }
  findTies(graph, loops);
  return loops;
}

PoseGraph believedGraph(const PoseGraph& graph, const std::vector<DoubtfulLoop>& loops) {
  PoseGraph believed{graph.poses, {}, graph.held, graph.points};
  auto loop = loops.begin();
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    const bool is_loop = loop != loops.end() && loop->constraint == k;
    if (!is_loop || loop->is_believed) {
      believed.constraints.push_back(graph.constraints[k]);
    }
    loop += is_loop ? 1 : 0;
  }
  return believed;
}

}  // namespace omega_slam::graph

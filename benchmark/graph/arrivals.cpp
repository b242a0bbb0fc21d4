#include "graph/arrivals.h"

#include <algorithm>

namespace omega_slam::experiments {

using graph::Constraint;

std::vector<Arrival> arrivalsOf(const graph::PoseGraph& graph) {
  std::vector<Arrival> arrivals(graph.poses.size());
  for (const Constraint& constraint : graph.constraints) {
    arrivals[std::max(constraint.from, constraint.to)].loops.push_back(constraint);
  }
  const auto is_later = [](const Constraint& a, const Constraint& b) {
    return std::min(a.from, a.to) > std::min(b.from, b.to);
  };
  for (auto& [ties, loops] : arrivals) {
    std::stable_sort(loops.begin(), loops.end(), is_later);
    if (!loops.empty()) {
      ties.push_back(loops.front());
      loops.erase(loops.begin());
    }
  }
  return arrivals;
}

}  // namespace omega_slam::experiments

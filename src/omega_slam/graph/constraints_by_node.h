#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// Which constraints touch each node of a graph, in their order. O(nodes + constraints) to make.
class ConstraintsByNode {
 public:
  explicit ConstraintsByNode(const PoseGraph& graph)
      : begins_(graph.poses.size() + 1, 0), indices_(2 * graph.constraints.size()) {
    for (const Constraint& constraint : graph.constraints) {
      ++begins_[constraint.from];
      ++begins_[constraint.to];
    }
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    for (std::size_t k = graph.constraints.size(); k-- > 0;) {  // ends become begins on the way
      indices_[--begins_[graph.constraints[k].to]] = k;
      indices_[--begins_[graph.constraints[k].from]] = k;
    }
  }

  /// @param act is given the index of each constraint
  template <typename Action>
  void forEach(NodeId node, Action act) const {
    std::for_each(indices_.data() + begins_[node], indices_.data() + begins_[node + 1], act);
  }

 private:
  std::vector<std::size_t> begins_;
  std::vector<std::size_t> indices_;
};

}  // namespace omega_slam::graph

#pragma once

#include <cstddef>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// The part of a graph that a new constraint is likely to move: the nodes within so many
/// constraints of it, with all that ties them together. Those on the rim are held, since what lies
/// beyond holds them.
class Neighbourhood {
 public:
  /// O(constraints of the whole) to find the ties, once.
  /// @param around constraints of the whole
  /// @param reach [constraints] > 0, to the rim
  Neighbourhood(const PoseGraph& whole, const std::vector<Constraint>& around, int reach);

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

  /// The part itself, at the whole's poses.
  [[nodiscard]] PoseGraph of(const PoseGraph& whole) const;

  /// [m] How far its outer half is from where the whole has it; turns by what they would move what
  /// lies 20 m away.
  [[nodiscard]] double outerMotion(const PoseGraph& part, const PoseGraph& whole) const;

  /// Gives the whole's nodes the poses of the part.
  void place(const PoseGraph& part, PoseGraph& whole) const;

 private:
  void grow(const PoseGraph& whole, int reach);
  void reachFor(NodeId node, int steps);

  std::vector<NodeId> nodes_;         ///< of the whole, those nearest to the constraints first
  std::vector<int> steps_;            ///< constraints to each of them, ascending
  std::vector<NodeId> numbers_;       ///< by node of the whole
  std::vector<std::size_t> touched_;  ///< constraints of the whole, ascending
  int reach_;
};

}  // namespace omega_slam::graph

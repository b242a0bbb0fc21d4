#pragma once

#include <cstddef>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// A graph without the nodes that are held and that no constraint is tied to, such as have retired.
/// The others keep their order, but not their numbers: so its solver's work is that of what is left
/// to estimate, however much has retired. Constraints keep their places.
class EstimatedPart {
 public:
  EstimatedPart() = default;
  explicit EstimatedPart(const PoseGraph& whole);  ///< O(nodes + constraints)

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  /// Which node of the whole each of its nodes is, ascending.
  [[nodiscard]] const std::vector<NodeId>& nodes() const { return nodes_; }

  /// @param node of the whole
  [[nodiscard]] bool has(NodeId node) const {
    return node < numbers_.size() && numbers_[node] != kNone;
  }
  /// The same constraint between its nodes. @pre it has both
  [[nodiscard]] Constraint renumbered(const Constraint& constraint) const;
  /// The part itself, at the whole's poses, with its constraints and held nodes.
  [[nodiscard]] PoseGraph of(const PoseGraph& whole) const;

  /// Takes in a node that comes after all others.
  void append(NodeId node);

  /// Gives the whole's nodes the poses of the part.
  void place(const std::vector<geometry::Pose2>& poses, PoseGraph& whole) const;

 private:
  static constexpr NodeId kNone = static_cast<NodeId>(-1);
  std::vector<NodeId> nodes_;
  std::vector<NodeId> numbers_;  ///< by node of the whole
};

}  // namespace omega_slam::graph

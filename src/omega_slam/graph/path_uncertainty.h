#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// How well the nodes of a graph are known from one of them: along the surest path of constraints
/// to each. What it says is never less than the marginal covariance, since other paths can only
/// add information, and it costs a search instead of a factorisation: the Dijkstra projection of
/// Bosse et al. 2004 ("Simultaneous localization and map building in large-scale cyclic
/// environments using the Atlas framework", IJRR 23, section 4.1).
///
/// Deviation: paths are compared by a sum over their constraints, the variance of the translation
/// and that of the rotation at an arm of 2 m; covariances are compounded along the winners only,
/// and only for the nodes that are asked for; the search goes no farther than to these. O(n + m) to
/// begin with, and O((n + m) log n) for all answers together.
///
/// Not thread-safe: answers are kept.
class PathUncertainty {
 public:
  /// @param graph solved; must outlive this. Constraints that say too little to be inverted lead
  /// nowhere
  /// @param root a node of it
  PathUncertainty(const PoseGraph& graph, NodeId root);

  [[nodiscard]] NodeId root() const { return root_; }
  [[nodiscard]] bool reaches(NodeId node) { return hops(node) >= 0; }
  /// Constraints on the path; -1 where there is none.
  [[nodiscard]] int hops(NodeId node);
  /// Of `T_root_node`, (x, y, theta) in the axes of the root [m^2, m rad, rad^2]; only where it
  /// reaches.
  [[nodiscard]] const Eigen::Matrix3d& covariance(NodeId node);
  /// [m] of the place, along the axis that is known least; infinite where there is no path.
  [[nodiscard]] double placeDeviation(NodeId node);
  /// [rad] likewise
  [[nodiscard]] double headingDeviation(NodeId node);

 private:
  /// What is known of the surest path to a node.
  struct Arrival {
    double cost;                ///< of the surest that is known so far
    int hops{-1};               ///< as long as none is known to be the surest
    NodeId before{0};           ///< on the path
    std::size_t constraint{0};  ///< that leads from there
  };

  /// A constraint as a step between its nodes, in either direction.
  struct Step {
    NodeId node{0};               ///< that it leads to
    std::uint32_t constraint{0};  ///< index
    double cost{0.0};
  };
  using Path = std::pair<double, NodeId>;  ///< its cost, and where it leads

  void listSteps();
  void settle(NodeId node);
  void compound(NodeId node);

  const PoseGraph& graph_;
  NodeId root_;
  geometry::Pose2 T_root_graph_;
  std::vector<std::size_t> first_steps_;  ///< of node i; those of the next follow
  std::vector<Step> steps_;
  std::priority_queue<Path, std::vector<Path>, std::greater<>> open_;
  std::vector<Arrival> arrivals_;  ///< by node
  std::vector<Eigen::Matrix3d> covariances_;
  std::vector<bool> is_compounded_;
};

}  // namespace omega_slam::graph

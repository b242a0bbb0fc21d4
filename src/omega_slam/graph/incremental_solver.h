#pragma once

#include <memory>
#include <string>
#include <vector>

#include "omega_slam/graph/estimated_part.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/solver.h"
#include "omega_slam/graph/updatable_cholesky.h"

namespace omega_slam::graph {

struct IncrementalConfig {
  SolverConfig solver;  ///< of finish(), and the kernels throughout
  /// Omega is ordered, linearised and factorised anew when so many nodes have come since,
  int batch_nodes{100};
  /// or when a pose has moved by more than this since [rad], [m]: then its Jacobians are stale.
  double max_turn{0.1};
  double max_move{1.0};

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// A graph that grows and is solved all the while, its held nodes excepted (node 0 where there are
/// none): every node and constraint is taken in at a cost far below that of a solve of the whole.
///
/// A node that is tied to earlier ones is a leaf: a 3 x 3 problem places it, and nothing else
/// moves. A constraint between known nodes changes the factor of Omega along one path of its
/// elimination tree, and a backward substitution gives all poses. Linearisation points stay until a
/// batch step (Kaess, Ranganathan and Dellaert, "iSAM: incremental smoothing and mapping", T-RO 24,
/// 2008, section IV), which comes early where a pose has moved far. Where no factor is at hand, or
/// kernels are to be weighed anew, only what lies around the constraint is solved for, as long as
/// the rest need not move. Nodes that are held and tied to nothing cost nothing.
class IncrementalSolver {
 public:
  explicit IncrementalSolver(
      const IncrementalConfig& config = {});  ///< @throws std::invalid_argument

  /// Adds a node and what ties it to earlier ones; the first needs no constraint.
  /// @param T_map_node first guess
  void addNode(const geometry::Pose2& T_map_node, const std::vector<Constraint>& constraints);

  /// Adds constraints between known nodes. All poses follow.
  void addConstraints(const std::vector<Constraint>& constraints);

  /// Adds constraints between known nodes, and solves for the poses around them until these rest.
  /// @return whether that was enough: what lies farther away need not move. Else all poses are as
  /// before, and wait for a solve of the whole
  [[nodiscard]] bool settleAround(const std::vector<Constraint>& constraints);

  /// Moves a node. @pre it is held, and no constraint is tied to it
  void place(NodeId node, const geometry::Pose2& T_map_node);

  /// Takes a constraint out again and solves until the poses rest.
  /// @param k index into the graph's constraints
  SolveReport withdraw(std::size_t k);

  /// Goes on with another graph, such as this one without some loops. Solves until the poses rest.
  SolveReport resume(PoseGraph graph);
  /// The same for a graph that is at rest, such as this one with nodes retired.
  void goOnWith(PoseGraph graph);

  /// Solves until the poses rest. Kernels are weighed anew at each step.
  SolveReport finish();

  [[nodiscard]] const PoseGraph& graph() const { return graph_; }
  [[nodiscard]] std::size_t batches() const { return batches_; }  ///< steps of the whole so far
  /// Nodes in the factor of Omega, but for the room for others; 0 where a batch step is due.
  [[nodiscard]] std::size_t factorized() const { return cholesky_ ? part_.size() : 0; }

 private:
  /// Whether the factor has the nodes of all.
  [[nodiscard]] bool isFor(const std::vector<Constraint>& constraints) const;
  [[nodiscard]] bool relaxAround(const std::vector<Constraint>& constraints);
  void include(const Constraint& constraint);
  void batch();
  void follow();
  [[nodiscard]] bool isStale() const;

  IncrementalConfig config_;
  PoseGraph graph_;                              ///< at the estimate
  EstimatedPart part_;                           ///< of it, which the factor is of
  std::vector<geometry::Pose2> linearized_at_;   ///< poses of the part
  std::unique_ptr<UpdatableCholesky> cholesky_;  ///< none where a batch step is due
  std::size_t capacity_{0};                      ///< nodes that the factor has room for
  std::size_t batches_{0};
  std::size_t solved_{0};  ///< nodes that there were at the last step of the whole
  GraphSolver solver_;
};

}  // namespace omega_slam::graph

#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/graph/information_form.h"
#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

struct SolverConfig {
  int max_iterations{20};
  double relative_gain{1e-6};  ///< stop when an iteration lowers the cost by less than this share
  double loop_kernel{
      1.0};  ///< Huber threshold of loop constraints, in standard deviations; 0: no kernel

  [[nodiscard]] std::vector<std::string> validate() const;
};

enum class SolveStatus {
  kConverged,
  kIterationLimit,  ///< better than before, but still moving
  kFailed           ///< the poses are those from before
};

struct SolveReport {
  SolveStatus status{SolveStatus::kConverged};
  int iterations{0};
  double initial_chi_square{0.0};  ///< sum of e^T Omega e before
  double chi_square{0.0};          ///< and after
  std::string message;             ///< what went wrong, if it did
};

/// Solves Omega mu = xi by a sparse Cholesky factorisation (SuiteSparse CHOLMOD).
/// @return mu, 3n values; none where Omega is not positive definite (an unconnected graph, say)
[[nodiscard]] std::optional<Eigen::VectorXd> solveLinear(const InformationForm& form);

/// Finds the most likely poses by Gauss-Newton: linearise every constraint at the poses, solve for
/// the step, repeat. Node 0 stays where it is. Steps that do not lower the cost are halved.
/// Deterministic. O(fill of the Cholesky factor) an iteration: near linear for a robot's path with
/// loops.
SolveReport solve(PoseGraph& graph, const SolverConfig& config = {});

/// Most likely pose of one node, all others held: the optimum of the whole graph where the node is
/// a new leaf.
/// @param constraints those that concern the node; none other is looked at
[[nodiscard]] geometry::Pose2 relaxNode(const PoseGraph& graph, NodeId node,
                                        const std::vector<Constraint>& constraints);

/// Squared Mahalanobis length e^T Omega e of one constraint at the graph's poses.
[[nodiscard]] double chiSquare(const PoseGraph& graph, const Constraint& constraint);

/// Sum of e^T Omega e over all constraints at the graph's poses, g2o's convention (see
/// linearize()); no kernel.
[[nodiscard]] double chiSquare(const PoseGraph& graph);

}  // namespace omega_slam::graph

#pragma once

#include <Eigen/Core>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// Error of a constraint at two poses, and its Jacobians with respect to additive steps (x, y,
/// theta) of either. e = (R_m^T (R_i^T (t_j - t_i) - t_m), wrap(theta_j - theta_i - theta_m)), with
/// m the measurement `T_from_to`: the translation error stands in the measurement's frame, as in
/// g2o (Kuemmerle et al. 2011).
struct LinearizedConstraint {
  Eigen::Vector3d error;
  Eigen::Matrix3d J_from;
  Eigen::Matrix3d J_to;
};

[[nodiscard]] LinearizedConstraint linearize(const Constraint& constraint,
                                             const geometry::Pose2& T_map_from,
                                             const geometry::Pose2& T_map_to);

/// The same at the graph's poses.
[[nodiscard]] LinearizedConstraint linearize(const Constraint& constraint, const PoseGraph& graph);

/// The error alone.
[[nodiscard]] Eigen::Vector3d errorOf(const Constraint& constraint, const PoseGraph& graph);

/// Squared Mahalanobis length e^T Omega e of one constraint at the graph's poses.
[[nodiscard]] double chiSquare(const PoseGraph& graph, const Constraint& constraint);

/// Sum of e^T Omega e over all constraints at the graph's poses, g2o's convention; no kernel.
[[nodiscard]] double chiSquare(const PoseGraph& graph);

}  // namespace omega_slam::graph

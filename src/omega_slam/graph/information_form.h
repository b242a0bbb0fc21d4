#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// Omega and xi of n poses: the 3n x 3n information matrix and the 3n information vector, of which
/// Omega mu = xi gives the most likely mu. Rows 3i, 3i+1, 3i+2 belong to x, y and theta of pose i.
///
/// The paper (section 6.1, equations 4 and 5) adds for each constraint between poses i and j the
/// block
/// [[1, -1], [-1, 1]] to Omega and (p_i - p_j, p_j - p_i) to xi. That is the special case of add()
/// for the error e = mu_j - mu_i - (p_j - p_i), whose Jacobians are -1 and 1, with unit
/// information.
class InformationForm {
 public:
  explicit InformationForm(std::size_t poses);

  /// Adds what one measurement says: e(mu) = J_i mu_i + J_j mu_j - z, weighted by its information.
  /// Omega gains J^T Lambda J, xi gains J^T Lambda z.
  void add(NodeId i, NodeId j, const Eigen::Matrix3d& J_i, const Eigen::Matrix3d& J_j,
           const Eigen::Matrix3d& information, const Eigen::Vector3d& z);

  /// Holds a pose at a value: without one pose held, nothing says where the whole graph lies (the
  /// gauge), and Omega is singular. Any positive weight gives the same solution.
  void anchor(NodeId i, const Eigen::Vector3d& value, double weight);

  /// The lower triangle of Omega, compressed. Its pattern depends only on which poses are tied
  /// together.
  [[nodiscard]] Eigen::SparseMatrix<double> omega() const;
  [[nodiscard]] const Eigen::VectorXd& xi() const { return xi_; }

 private:
  void addBlock(NodeId row, NodeId column, const Eigen::Matrix3d& block);

  std::vector<Eigen::Triplet<double>> triplets_;
  Eigen::VectorXd xi_;
};

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

/// The paper's equations as they stand: unit information, headings as if they were known, node 0
/// held at `origin`.
/// @param constraints `T_from_to` is taken as the difference p_to - p_from in the map's axes
[[nodiscard]] InformationForm paperForm(const std::vector<Constraint>& constraints,
                                        std::size_t poses, const geometry::Pose2& origin = {});

}  // namespace omega_slam::graph

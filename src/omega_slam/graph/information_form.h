#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

#include "omega_slam/graph/linearization.h"
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
///
/// Which blocks of Omega are not zero depends on which poses are tied together alone, so the
/// places of all constraints are found once, and the form can be cleared and filled again.
class InformationForm {
 public:
  /// @param held nodes whose mu is zero, whatever is added: as steps, they stay where they are.
  /// Without one, nothing says where the whole graph lies (the gauge), and Omega is singular.
  InformationForm(std::size_t poses, const std::vector<Constraint>& constraints,
                  const std::vector<NodeId>& held);

  /// All sums to zero, but for held nodes, whose equation is mu = 0.
  void clear();

  /// Adds what one measurement says: e(mu) = e + J_i mu_i + J_j mu_j, weighted by its information
  /// Lambda. Omega gains J^T Lambda J, xi loses J^T Lambda e.
  /// @param k index of the constraint, as given to the constructor
  void add(std::size_t k, const LinearizedConstraint& at, const Eigen::Matrix3d& information);

  /// Adds `share` times the diagonal of Omega to it (Marquardt 1963).
  void damp(double share);

  /// Adds to one element of the diagonal: for what no constraint says anything of.
  void addDiagonal(NodeId node, int axis, double value);

  /// The lower triangle, compressed. Its pattern stays as it is.
  [[nodiscard]] const Eigen::SparseMatrix<double>& omega() const { return omega_; }
  [[nodiscard]] const Eigen::VectorXd& xi() const { return xi_; }
  /// Which nodes are held.
  [[nodiscard]] const std::vector<bool>& held() const { return held_; }
  /// Which poses share a block of Omega: n x n, lower triangle.
  [[nodiscard]] const Eigen::SparseMatrix<double>& blocks() const { return blocks_; }

 private:
  /// Where a block stands among Omega's values: its first element, and how far apart its columns
  /// are. Nowhere where a node is held.
  struct Block {
    Eigen::Index first{-1};
    Eigen::Index stride{0};

    [[nodiscard]] bool isThere() const { return first >= 0; }
    [[nodiscard]] Eigen::Index diagonal(int axis) const { return first + axis * (stride + 1); }
  };
  struct Place {
    Eigen::Index from{0};  ///< row of xi
    Eigen::Index to{0};
    Block from_from;
    Block to_to;
    Block across;  ///< of the later node's row and the earlier one's column
    bool to_is_later{true};
  };

  void buildBlocks(std::size_t poses, const std::vector<Constraint>& constraints);
  void buildOmega();
  [[nodiscard]] Block blockAt(NodeId row, NodeId column) const;
  [[nodiscard]] Place placeOf(const Constraint& constraint) const;
  void addTo(const Block& block, const Eigen::Matrix3d& values);

  std::vector<bool> held_;
  Eigen::SparseMatrix<double> blocks_;
  Eigen::SparseMatrix<double> omega_;
  Eigen::VectorXd xi_;
  std::vector<Place> places_;
};

/// The paper's error of a constraint: unit Jacobians, since headings are taken as known.
/// @param T_map_from gives the heading by which the measured step is turned into the map's axes
[[nodiscard]] LinearizedConstraint paperConstraint(const Constraint& constraint,
                                                   const geometry::Pose2& T_map_from,
                                                   const geometry::Pose2& T_map_to);

}  // namespace omega_slam::graph

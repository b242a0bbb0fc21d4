#pragma once

#include <Eigen/Core>
#include <vector>

#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/sparse_cholesky.h"

namespace omega_slam::graph {

/// Those elements of Omega^-1 at which Omega's factor has elements: the covariances of all poses,
/// and of all pairs of poses that share a constraint, at about twice the price of a factorisation.
///
/// Takahashi, Fagan and Chin, "Formation of a sparse bus impedance matrix and its application to
/// short circuit study", PICA 1973: column by column from the last one, each from those after it.
/// Here columns that share their rows are taken together, which makes it a matter of small dense
/// products.
class SelectedInverse {
 public:
  /// @param columns of a positive definite Omega
  explicit SelectedInverse(const FactorColumns& columns);

  /// The 3 x 3 block of Omega^-1 of node a's rows and node b's columns. Elements at which the
  /// factor has none are given as zero, as a held node's are; of others it says nothing.
  /// @pre a == b, or the form that was factorised had a constraint between the two
  [[nodiscard]] Eigen::Matrix3d block(NodeId a, NodeId b) const;

 private:
  /// Columns first, first + 1, ... of which each has the rows of the one before but for its first.
  struct Panel {
    int first{0};
    int count{0};
    std::vector<int> rows;   ///< below the columns' own
    Eigen::MatrixXd values;  ///< of the inverse: the columns' own rows, then `rows`
  };

  void findPanels(const FactorColumns& columns);
  void invert(const FactorColumns& columns, Panel& panel);
  [[nodiscard]] Eigen::MatrixXd gather(const std::vector<int>& rows);
  [[nodiscard]] double element(int row, int column) const;

  std::vector<int> place_;     ///< in the factor, of each row of Omega
  std::vector<int> panel_of_;  ///< each column
  std::vector<Panel> panels_;
  std::vector<int> position_;  ///< of rows in one panel: room for gather()
};

}  // namespace omega_slam::graph

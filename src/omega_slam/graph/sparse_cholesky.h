#pragma once

#include <Eigen/Core>
#include <vector>

#include "omega_slam/graph/dense_elimination.h"
#include "omega_slam/graph/elimination_plan.h"
#include "omega_slam/graph/information_form.h"

namespace omega_slam::graph {

/// The factor L of P Omega P^T = L L^T, column by column, each column's rows ascending and its
/// diagonal first.
struct FactorColumns {
  std::vector<int> order;   ///< row `order[i]` of Omega is row i of L
  std::vector<int> starts;  ///< by column, of rows and values; and the end of the last one
  std::vector<int> rows;
  std::vector<double> values;
};

/// Solves Omega mu = xi by a sparse Cholesky factorisation: multifrontal (Duff and Reid, "The
/// multifrontal solution of indefinite sparse symmetric linear equations", TOMS 9, 1983; Davis,
/// "Direct Methods for Sparse Linear Systems", 2006).
///
/// Omega is made of 3 x 3 blocks, and its factor of panels of them. Each panel is eliminated
/// densely and leaves an update for its parent's rows. The plan for it is made once and serves
/// every form of the same pattern.
class SparseCholesky {
 public:
  /// Plans.
  explicit SparseCholesky(const InformationForm& form);

  /// @param form of the pattern that was planned for
  /// @return whether Omega is positive definite; if not, there is nothing to solve with
  bool factorize(const InformationForm& form);

  /// mu for the Omega that was factorised last. O(elements of the factor).
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& xi) const;

  /// A copy of the factor that was made last. Elements that happen to be zero are kept.
  [[nodiscard]] FactorColumns columns() const;

  /// Elements of the factor, some of which are zero.
  [[nodiscard]] Eigen::Index factorSize() const { return plan_.elements; }

 private:
  /// Where a block of Omega goes.
  struct Target {
    Eigen::Index element;  ///< of the panels
    Eigen::Index stride;   ///< from column to column
    bool is_transposed;
  };
  /// What a panel leaves to its parent, in the rows below it.
  struct Update {
    std::size_t panel;
    Eigen::MatrixXd values;  ///< lower triangle
  };

  [[nodiscard]] ConstPanelMap columnsOf(const Panel& panel) const;
  [[nodiscard]] Target targetOf(int row, int column) const;
  void place(const Eigen::SparseMatrix<double>& omega);
  bool eliminatePanel(std::size_t index, std::vector<Update>& updates);

  EliminationPlan plan_;
  std::vector<Target> targets_;  ///< by block of Omega
  Eigen::VectorXd elements_;     ///< of all panels
};

}  // namespace omega_slam::graph

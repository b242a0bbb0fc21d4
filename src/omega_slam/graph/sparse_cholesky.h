#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

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

/// Solves Omega mu = xi by a sparse Cholesky factorisation (SuiteSparse CHOLMOD: Davis, "Direct
/// Methods for Sparse Linear Systems", 2006).
///
/// Poses, not single rows, are ordered to keep the factor sparse, by approximate minimum degree:
/// the graph of the poses is nine times smaller than that of the rows, and no worse a guide. The
/// ordering and the symbolic factorisation are made once and serve every form of the same pattern.
/// CHOLMOD decides by the work that each element takes whether columns are taken together in dense
/// blocks (supernodal) or one by one (simplicial).
class SparseCholesky {
 public:
  /// Orders and analyses.
  explicit SparseCholesky(const InformationForm& form);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// @param form of the pattern that was analysed
  /// @return whether Omega is positive definite; if not, there is nothing to solve with
  bool factorize(const InformationForm& form);

  /// mu for the Omega that was factorised last. O(elements of the factor).
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& xi) const;

  /// mu for an Omega close to the one that was factorised, by conjugate gradients with the old
  /// factor as the preconditioner (Golub and Van Loan, "Matrix Computations", section 11.5): much
  /// cheaper than a factorisation while few steps suffice.
  /// @param tolerance of the residual, relative to xi, both in the metric of the old Omega
  /// @return none where `max_steps` steps do not
  [[nodiscard]] std::optional<Eigen::VectorXd> solveNearby(const InformationForm& form,
                                                           double tolerance, int max_steps) const;

  /// A copy of the factor that was made last. Elements that happen to be zero are kept.
  [[nodiscard]] FactorColumns columns() const;

  /// Elements of the factor, and the work of computing it [floating point operations].
  [[nodiscard]] double factorSize() const;
  [[nodiscard]] double factorWork() const;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace omega_slam::graph

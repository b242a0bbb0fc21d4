#pragma once

#include <Eigen/Core>
#include <memory>

#include "omega_slam/graph/information_form.h"

namespace omega_slam::graph {

/// A factorisation of Omega that takes in single constraints as they come: each changes the factor
/// along one path of the elimination tree only (Davis and Hager, "Row modifications of a sparse
/// Cholesky factorization", SIAM J. Matrix Anal. Appl. 26, 2005; SuiteSparse CHOLMOD's updown).
/// The forward solution follows along, so that only the backward one is left when mu is asked for.
class UpdatableCholesky {
 public:
  /// Orders, analyses and factorises. Nodes from `open` on are ordered last: those that constraints
  /// are still to come for. Whatever is added beyond the form's pattern fills the factor.
  UpdatableCholesky(const InformationForm& form, NodeId open);
  ~UpdatableCholesky();
  UpdatableCholesky(const UpdatableCholesky&) = delete;
  UpdatableCholesky& operator=(const UpdatableCholesky&) = delete;

  /// Whether Omega is positive definite.
  [[nodiscard]] bool isValid() const { return is_valid_; }

  /// Adds what one measurement says, as InformationForm::add() does. A node's part is left out
  /// where it is held.
  void add(const Constraint& constraint, const LinearizedConstraint& at, double weight);

  /// mu for all that was added. O(elements of the factor).
  [[nodiscard]] Eigen::VectorXd solve() const;

  /// Elements of the factor: grows as constraints are added.
  [[nodiscard]] double factorSize() const;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
  bool is_valid_{false};
};

}  // namespace omega_slam::graph

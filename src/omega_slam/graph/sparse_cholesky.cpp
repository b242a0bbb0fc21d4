#include "omega_slam/graph/sparse_cholesky.h"

// CHOLMOD's header before Eigen's wrapper, which expects it.
#include <cholmod.h>

#include <Eigen/CholmodSupport>
#include <vector>

namespace omega_slam::graph {
namespace {

/// A view, not a copy; CHOLMOD does not write to it.
cholmod_sparse lowerOf(const Eigen::SparseMatrix<double>& matrix) {
  return Eigen::viewAsCholmod(matrix.selfadjointView<Eigen::Lower>());
}

}  // namespace

struct SparseCholesky::Cholmod {
  Cholmod() { cholmod_start(&common); }
  ~Cholmod() {
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&work_y, &common);
    cholmod_free_dense(&work_e, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;

  cholmod_common common{};
  cholmod_factor* factor{nullptr};
  // Kept from solve to solve.
  cholmod_dense* solution{nullptr};
  cholmod_dense* work_y{nullptr};
  cholmod_dense* work_e{nullptr};
};

SparseCholesky::SparseCholesky(const InformationForm& form)
    : cholmod_(std::make_unique<Cholmod>()) {
  cholmod_common& common = cholmod_->common;
  common.print = 0;  // a matrix that can't be factorised is an answer, not an event
  cholmod_sparse blocks = lowerOf(form.blocks());
  std::vector<int> order(blocks.ncol);
  cholmod_amd(&blocks, nullptr, 0, order.data(), &common);
  std::vector<int> rows;
  rows.reserve(3 * order.size());
  for (const int node : order) {
    rows.insert(rows.end(), {3 * node, 3 * node + 1, 3 * node + 2});
  }
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
  common.postorder = 1;
  cholmod_sparse omega = lowerOf(form.omega());
  cholmod_->factor = cholmod_analyze_p(&omega, rows.data(), nullptr, 0, &common);
}

SparseCholesky::~SparseCholesky() = default;

bool SparseCholesky::factorize(const InformationForm& form) {
  cholmod_sparse omega = lowerOf(form.omega());
  cholmod_factorize(&omega, cholmod_->factor, &cholmod_->common);
  const auto& factor = *cholmod_->factor;
  return cholmod_->common.status == CHOLMOD_OK && factor.minor == factor.n;
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& xi) const {
  cholmod_dense right = Eigen::viewAsCholmod(const_cast<Eigen::VectorXd&>(xi));
  cholmod_solve2(CHOLMOD_A, cholmod_->factor, &right, nullptr, &cholmod_->solution, nullptr,
                 &cholmod_->work_y, &cholmod_->work_e, &cholmod_->common);
  return Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(cholmod_->solution->x),
                                           xi.size());
}

std::optional<Eigen::VectorXd> SparseCholesky::solveNearby(const InformationForm& form,
                                                           double tolerance, int max_steps) const {
  const auto omega = form.omega().selfadjointView<Eigen::Lower>();
  Eigen::VectorXd residual = form.xi();
  Eigen::VectorXd preconditioned = solve(residual);
  Eigen::VectorXd direction = preconditioned;
  Eigen::VectorXd mu = Eigen::VectorXd::Zero(residual.size());
  double length = residual.dot(preconditioned);
  const double enough = tolerance * tolerance * length;
  for (int step = 0; step < max_steps; ++step) {
    const Eigen::VectorXd pushed = omega * direction;
    const double share = length / direction.dot(pushed);
    mu += share * direction;
    residual -= share * pushed;
    preconditioned = solve(residual);
    const double shorter = residual.dot(preconditioned);
    if (shorter <= enough && mu.allFinite()) {
      return mu;
    }
    direction = preconditioned + (shorter / length) * direction;
    length = shorter;
  }
  return std::nullopt;
}

FactorColumns SparseCholesky::columns() const {
  cholmod_factor* factor = cholmod_copy_factor(cholmod_->factor, &cholmod_->common);
  cholmod_change_factor(CHOLMOD_REAL, true, false, true, true, factor, &cholmod_->common);
  const auto* order = static_cast<const int*>(factor->Perm);
  const auto* starts = static_cast<const int*>(factor->p);
  const auto* rows = static_cast<const int*>(factor->i);
  const auto* values = static_cast<const double*>(factor->x);
  const int size = static_cast<int>(factor->n);
  FactorColumns columns{{order, order + size},
                        {starts, starts + size + 1},
                        {rows, rows + starts[size]},
                        {values, values + starts[size]}};
  cholmod_free_factor(&factor, &cholmod_->common);
  return columns;
}

double SparseCholesky::factorSize() const { return cholmod_->common.lnz; }

double SparseCholesky::factorWork() const { return cholmod_->common.fl; }

}  // namespace omega_slam::graph

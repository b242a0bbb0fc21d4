#include "omega_slam/graph/updatable_cholesky.h"

// CHOLMOD's header before Eigen's wrapper, which expects it.
#include <cholmod.h>

#include <Eigen/CholmodSupport>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace omega_slam::graph {

struct UpdatableCholesky::Cholmod {
  Cholmod() { cholmod_start(&common); }
  ~Cholmod() {
    cholmod_free_dense(&forward, &common);
    cholmod_free_dense(&change, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;

  cholmod_common common{};
  cholmod_factor* factor{nullptr};
  cholmod_dense* forward{nullptr};  ///< L^-1 xi, in the factor's order
  cholmod_dense* change{nullptr};   ///< of xi, in that order; zero but within add()
  std::vector<int> position;        ///< of each row of Omega in the factor's order
  std::vector<bool> is_held;        ///< by node
};

namespace {

std::vector<int> rowsOf(const std::vector<int>& nodes) {
  std::vector<int> rows;
  rows.reserve(3 * nodes.size());
  for (const int node : nodes) {
    rows.insert(rows.end(), {3 * node, 3 * node + 1, 3 * node + 2});
  }
  return rows;
}

/// Approximate minimum degree among the nodes before `open`; the open ones then, in their own
/// order.
std::vector<int> orderNodes(const InformationForm& form, NodeId open, cholmod_common& common) {
  const auto closed = static_cast<Eigen::Index>(open);
  const Eigen::SparseMatrix<double> blocks = form.blocks().topLeftCorner(closed, closed);
  cholmod_sparse view = Eigen::viewAsCholmod(blocks.selfadjointView<Eigen::Lower>());
  std::vector<int> order(static_cast<std::size_t>(form.blocks().rows()));
  std::iota(order.begin(), order.end(), 0);
  if (open > 0) {
    cholmod_amd(&view, nullptr, 0, order.data(), &common);
  }
  return order;
}

/// A row of the matrix whose square is added to Omega, in the factor's order.
struct UpdateRow {
  int position;
  Eigen::RowVector3d values;
};

/// That matrix: three columns, column by column.
class UpdateColumns {
 public:
  /// @param rows at most six, in the order of their positions
  explicit UpdateColumns(const std::vector<UpdateRow>& rows) {
    std::size_t element = 0;
    for (std::size_t column = 0; column < 3; ++column) {
      for (const UpdateRow& row : rows) {
        indices_[element] = row.position;
        values_[element] = row.values[static_cast<Eigen::Index>(column)];
        ++element;
      }
      columns_[column + 1] = static_cast<int>(element);
    }
  }

  /// Valid while this object stands.
  [[nodiscard]] cholmod_sparse view(std::size_t height) {
    cholmod_sparse matrix{};
    matrix.nrow = height;
    matrix.ncol = 3;
    matrix.nzmax = values_.size();
    matrix.p = columns_.data();
    matrix.i = indices_.data();
    matrix.x = values_.data();
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_REAL;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = 1;
    matrix.packed = 1;
    return matrix;
  }

 private:
  std::array<double, 18> values_{};
  std::array<int, 18> indices_{};
  std::array<int, 4> columns_{};
};

/// S with S S^T = information: three columns, of which some may be zero.
Eigen::Matrix3d rootOf(const Eigen::Matrix3d& information) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(information);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

}  // namespace

UpdatableCholesky::UpdatableCholesky(const InformationForm& form, NodeId open)
    : cholmod_(std::make_unique<Cholmod>()) {
  cholmod_common& common = cholmod_->common;
  common.print = 0;
  const std::vector<int> rows = rowsOf(orderNodes(form, open, common));
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
  common.postorder = 0;  // would move the open nodes from the end
  common.supernodal = CHOLMOD_SIMPLICIAL;
  common.final_ll = 0;  // LDL^T, which is what can be updated
  cholmod_sparse omega = Eigen::viewAsCholmod(form.omega().selfadjointView<Eigen::Lower>());
  cholmod_->factor = cholmod_analyze_p(&omega, const_cast<int*>(rows.data()), nullptr, 0, &common);
  cholmod_factorize(&omega, cholmod_->factor, &common);
  const cholmod_factor& factor = *cholmod_->factor;
  is_valid_ = common.status == CHOLMOD_OK && factor.minor == factor.n;
  cholmod_->is_held = form.held();
  cholmod_->position.resize(factor.n);
  const auto* const permutation = static_cast<const int*>(factor.Perm);
  for (std::size_t k = 0; k < factor.n; ++k) {
    cholmod_->position[static_cast<std::size_t>(permutation[k])] = static_cast<int>(k);
  }
  cholmod_->change = cholmod_zeros(factor.n, 1, CHOLMOD_REAL, &common);
  cholmod_dense* const xi = cholmod_zeros(factor.n, 1, CHOLMOD_REAL, &common);
  for (std::size_t row = 0; row < factor.n; ++row) {
    static_cast<double*>(xi->x)[cholmod_->position[row]] =
        form.xi()[static_cast<Eigen::Index>(row)];
  }
  cholmod_->forward = cholmod_solve(CHOLMOD_L, cholmod_->factor, xi, &common);
  cholmod_dense* used = xi;
  cholmod_free_dense(&used, &common);
}

UpdatableCholesky::~UpdatableCholesky() = default;

void UpdatableCholesky::add(const Constraint& constraint, const LinearizedConstraint& at,
                            double weight) {
  Cholmod& c = *cholmod_;
  const Eigen::Matrix3d root = rootOf(weight * constraint.information);
  const Eigen::Vector3d pull = weight * constraint.information * at.error;
  std::vector<UpdateRow> rows;
  const auto addNode = [&](NodeId node, const Eigen::Matrix3d& jacobian) {
    if (c.is_held[node]) {
      return;
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const int position = c.position[3 * node + static_cast<std::size_t>(axis)];
      rows.push_back({position, (jacobian.transpose() * root).row(axis)});
      static_cast<double*>(c.change->x)[position] -= jacobian.col(axis).dot(pull);
    }
  };
  addNode(constraint.from, at.J_from);
  addNode(constraint.to, at.J_to);
  std::sort(rows.begin(), rows.end(),
            [](const UpdateRow& a, const UpdateRow& b) { return a.position < b.position; });
  UpdateColumns columns(rows);
  cholmod_sparse update = columns.view(c.factor->n);
  cholmod_updown_solve(1, &update, c.factor, c.forward, c.change, &c.common);
}

Eigen::VectorXd UpdatableCholesky::solve() const {
  Cholmod& c = *cholmod_;
  cholmod_dense* backward = cholmod_solve(CHOLMOD_DLt, c.factor, c.forward, &c.common);
  const auto* const values = static_cast<const double*>(backward->x);
  Eigen::VectorXd mu(static_cast<Eigen::Index>(c.position.size()));
  for (std::size_t row = 0; row < c.position.size(); ++row) {
    mu[static_cast<Eigen::Index>(row)] = values[c.position[row]];
  }
  cholmod_free_dense(&backward, &c.common);
  return mu;
}

double UpdatableCholesky::factorSize() const {
  double size = 0.0;
  const auto* const counts = static_cast<const int*>(cholmod_->factor->nz);
  for (std::size_t column = 0; column < cholmod_->factor->n; ++column) {
    size += counts[column];
  }
  return size;
}

}  // namespace omega_slam::graph

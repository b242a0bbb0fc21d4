#include "omega_slam/graph/selected_inverse.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

namespace omega_slam::graph {

SelectedInverse::SelectedInverse(const FactorColumns& columns)
    : place_(columns.order.size()),
      panel_of_(columns.order.size()),
      position_(columns.order.size()) {
  for (std::size_t i = 0; i < columns.order.size(); ++i) {
    place_[static_cast<std::size_t>(columns.order[i])] = static_cast<int>(i);
  }
  findPanels(columns);
  for (auto panel = panels_.rbegin(); panel != panels_.rend(); ++panel) {
    invert(columns, *panel);
  }
}

void SelectedInverse::findPanels(const FactorColumns& columns) {
  const int size = static_cast<int>(columns.order.size());
  const auto start = [&](int column) { return columns.starts[static_cast<std::size_t>(column)]; };
  const auto continuesPanel = [&](int column) {
    const int before = start(column) - start(column - 1);
    return before == start(column + 1) - start(column) + 1 && before > 1 &&
           columns.rows[static_cast<std::size_t>(start(column - 1)) + 1] == column;
  };
  for (int column = 0; column < size; ++column) {
    if (column == 0 || !continuesPanel(column)) {
      panels_.push_back({column, 0, {}, {}});
    }
    ++panels_.back().count;
    panel_of_[static_cast<std::size_t>(column)] = static_cast<int>(panels_.size()) - 1;
  }
  for (Panel& panel : panels_) {
    const int last = panel.first + panel.count - 1;
    panel.rows.assign(columns.rows.begin() + start(last) + 1,
                      columns.rows.begin() + start(last + 1));
  }
}

/// With L's columns of the panel as [L1; L2], and Z2 the inverse at the rows of L2, which later
/// panels have: Y = L2 L1^-1, the lower part is -Z2 Y, the upper one (L1 L1^T)^-1 + Y^T Z2 Y.
void SelectedInverse::invert(const FactorColumns& columns, Panel& panel) {
  const auto below = static_cast<Eigen::Index>(panel.rows.size());
  Eigen::MatrixXd own = Eigen::MatrixXd::Zero(panel.count, panel.count);
  Eigen::MatrixXd under(below, panel.count);
  for (int i = 0; i < panel.count; ++i) {
    const double* values =
        columns.values.data() + columns.starts[static_cast<std::size_t>(panel.first + i)];
    const Eigen::Index rest = panel.count - i;
    own.col(i).tail(rest) = Eigen::Map<const Eigen::VectorXd>(values, rest);
    under.col(i) = Eigen::Map<const Eigen::VectorXd>(values + rest, below);
  }
  const auto lower = own.triangularView<Eigen::Lower>();
  const Eigen::MatrixXd own_inverse =
      lower.solve(Eigen::MatrixXd::Identity(panel.count, panel.count));
  panel.values.resize(panel.count + below, panel.count);
  panel.values.topRows(panel.count) = own_inverse.transpose() * own_inverse;
  if (below > 0) {
    lower.solveInPlace<Eigen::OnTheRight>(under);
    panel.values.bottomRows(below).noalias() = -gather(panel.rows) * under;
    panel.values.topRows(panel.count) -= under.transpose() * panel.values.bottomRows(below);
  }
}

Eigen::MatrixXd SelectedInverse::gather(const std::vector<int>& rows) {
  const std::size_t size = rows.size();
  Eigen::MatrixXd result(size, size);
  int known = -1;  // the panel whose rows' positions are at hand
  for (std::size_t j = 0; j < size; ++j) {
    const int index = panel_of_[static_cast<std::size_t>(rows[j])];
    const Panel& panel = panels_[static_cast<std::size_t>(index)];
    if (index != known) {
      known = index;
      for (int i = 0; i < panel.count; ++i) {
        position_[static_cast<std::size_t>(panel.first + i)] = i;
      }
      for (std::size_t i = 0; i < panel.rows.size(); ++i) {
        position_[static_cast<std::size_t>(panel.rows[i])] = panel.count + static_cast<int>(i);
      }
    }
    for (std::size_t i = j; i < size; ++i) {
      const double value =
          panel.values(position_[static_cast<std::size_t>(rows[i])], rows[j] - panel.first);
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = value;
      result(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = value;
    }
  }
  return result;
}

double SelectedInverse::element(int row, int column) const {
  const auto [low, high] = std::minmax(row, column);
  const Panel& panel = panels_[static_cast<std::size_t>(panel_of_[static_cast<std::size_t>(low)])];
  const int own = high - panel.first;
  if (own < panel.count) {
    return panel.values(own, low - panel.first);
  }
  const auto found = std::lower_bound(panel.rows.begin(), panel.rows.end(), high);
  if (found == panel.rows.end() || *found != high) {
    return 0.0;
  }
  return panel.values(panel.count + (found - panel.rows.begin()), low - panel.first);
}

Eigen::Matrix3d SelectedInverse::block(NodeId a, NodeId b) const {
  Eigen::Matrix3d block;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      block(i, j) = element(place_[3 * std::size_t{a} + static_cast<std::size_t>(i)],
                            place_[3 * std::size_t{b} + static_cast<std::size_t>(j)]);
    }
  }
  return block;
}

}  // namespace omega_slam::graph

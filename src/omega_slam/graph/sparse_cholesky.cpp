#include "omega_slam/graph/sparse_cholesky.h"

#include <algorithm>
#include <utility>

namespace omega_slam::graph {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Nodes [first, end) of a front, with their rows and columns.
struct FrontPart {
  double* elements;
  Index stride;  ///< from column to column
  int first;
  int end;

  [[nodiscard]] double* at(int row, int column) const {
    return elements + 3 * (column - first) * stride + 3 * (row - first);
  }
};

/// Adds a child's update to its parent's front: those of its columns that fall into the part.
/// @param rows of the parent, by node of the child
void addUpdate(const Eigen::MatrixXd& update, const std::vector<int>& rows, const FrontPart& part) {
  const auto count = static_cast<Index>(rows.size());
  const auto indexOf = [&](int row) {
    return std::lower_bound(rows.begin(), rows.end(), row) - rows.begin();
  };
  const int* const to = rows.data();
  for (Index column = indexOf(part.first); column < indexOf(part.end); ++column) {
    for (Index row = column; row < count;) {
      Index end = row + 1;  // of rows that lie side by side in both
      while (end < count && to[end] - to[row] == end - row) {
        ++end;
      }
      const Index length = 3 * (end - row);
      double* target = part.at(to[row], to[column]);
      for (Index axis = 0; axis < 3; ++axis, target += part.stride) {
        Eigen::Map<VectorXd>(target, length) +=
            update.col(3 * column + axis).segment(3 * row, length);
      }
      row = end;
    }
  }
}

}  // namespace

SparseCholesky::SparseCholesky(const InformationForm& form)
    : plan_(form.blocks()), elements_(plan_.elements) {
  const Eigen::SparseMatrix<double>& blocks = form.blocks();
  targets_.reserve(static_cast<std::size_t>(blocks.nonZeros()));
  for (int column = 0; column < blocks.cols(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator block(blocks, column); block; ++block) {
      targets_.push_back(targetOf(plan_.place[block.row()], plan_.place[column]));
    }
  }
}

ConstPanelMap SparseCholesky::columnsOf(const Panel& panel) const {
  return {elements_.data() + panel.first_element, 3 * panel.height(), 3 * panel.count};
}

SparseCholesky::Target SparseCholesky::targetOf(int row, int column) const {
  const auto [earlier, later] = std::minmax(row, column);
  const Panel& panel = plan_.panels[static_cast<std::size_t>(plan_.panel_of[earlier])];
  const Index stride = 3 * panel.height();
  return {panel.first_element + 3 * (earlier - panel.first) * stride + 3 * panel.rowOf(later),
          stride, row < column};
}

void SparseCholesky::place(const Eigen::SparseMatrix<double>& omega) {
  using Strided = Eigen::OuterStride<>;
  elements_.setZero();
  auto target = targets_.begin();
  for (Index column = 0; column < omega.cols(); column += 3) {
    const Index begin = omega.outerIndexPtr()[column];
    const Index stride = omega.outerIndexPtr()[column + 1] - begin;
    for (Index row = 0; row < stride; row += 3, ++target) {
      const Eigen::Map<const Eigen::Matrix3d, 0, Strided> block(omega.valuePtr() + begin + row,
                                                                Strided(stride));
      Eigen::Map<Eigen::Matrix3d, 0, Strided> place(elements_.data() + target->element,
                                                    Strided(target->stride));
      if (target->is_transposed) {
        place = block.transpose();
      } else {
        place = block;
      }
    }
  }
}

bool SparseCholesky::eliminatePanel(std::size_t index, std::vector<Update>& updates) {
  const Panel& panel = plan_.panels[index];
  const auto is_other = [&](const Update& update) {
    return plan_.panels[update.panel].parent != static_cast<int>(index);
  };
  const auto children = std::find_if(updates.rbegin(), updates.rend(), is_other).base();
  const auto addChildren = [&](const FrontPart& part) {
    std::for_each(children, updates.end(), [&](const Update& child) {
      addUpdate(child.values, plan_.panels[child.panel].in_parent, part);
    });
  };
  PanelMap columns(elements_.data() + panel.first_element, 3 * panel.height(), 3 * panel.count);
  addChildren({columns.data(), columns.rows(), 0, panel.count});
  if (!eliminate(columns)) {
    return false;
  }
  Update update{index, leftBy(columnsOf(panel))};
  addChildren({update.values.data(), update.values.rows(), panel.count, panel.height()});
  updates.erase(children, updates.end());
  if (!panel.rows.empty()) {
    updates.push_back(std::move(update));
  }
  return true;
}

bool SparseCholesky::factorize(const InformationForm& form) {
  place(form.omega());
  std::vector<Update> updates;  // not yet taken in, those of a panel's children last
  for (std::size_t index = 0; index < plan_.panels.size(); ++index) {
    if (!eliminatePanel(index, updates)) {
      return false;
    }
  }
  return true;
}

VectorXd SparseCholesky::solve(const VectorXd& xi) const {
  VectorXd mu(xi.size());  // in the order of elimination
  for (Index node = 0; node < plan_.place.size(); ++node) {
    mu.segment<3>(3 * plan_.place[node]) = xi.segment<3>(3 * node);
  }
  VectorXd front;  // mu in the rows of a panel
  for (const Panel& panel : plan_.panels) {
    const Index own = 3 * panel.count;
    front.setZero(3 * panel.height());
    front.head(own) = mu.segment(3 * panel.first, own);
    substituteForward(columnsOf(panel), front);
    mu.segment(3 * panel.first, own) = front.head(own);
    for (std::size_t i = 0; i < panel.rows.size(); ++i) {
      mu.segment<3>(3 * panel.rows[i]) += front.segment<3>(own + 3 * static_cast<Index>(i));
    }
  }
  for (auto panel = plan_.panels.rbegin(); panel != plan_.panels.rend(); ++panel) {
    const Index own = 3 * panel->count;
    front.resize(3 * panel->height());
    front.head(own) = mu.segment(3 * panel->first, own);
    for (std::size_t i = 0; i < panel->rows.size(); ++i) {
      front.segment<3>(own + 3 * static_cast<Index>(i)) = mu.segment<3>(3 * panel->rows[i]);
    }
    substituteBackward(columnsOf(*panel), front);
    mu.segment(3 * panel->first, own) = front.head(own);
  }
  VectorXd result(xi.size());
  for (Index node = 0; node < plan_.place.size(); ++node) {
    result.segment<3>(3 * node) = mu.segment<3>(3 * plan_.place[node]);
  }
  return result;
}

FactorColumns SparseCholesky::columns() const {
  FactorColumns columns{std::vector<int>(3 * plan_.place.size()), {0}, {}, {}};
  for (int node = 0; node < plan_.place.size(); ++node) {
    for (int axis = 0; axis < 3; ++axis) {
      columns.order[static_cast<std::size_t>(3 * plan_.place[node] + axis)] = 3 * node + axis;
    }
  }
  for (const Panel& panel : plan_.panels) {
    std::vector<int> rows;
    for (int node = 0; node < panel.height(); ++node) {
      const int row = 3 * panel.nodeOf(node);
      rows.insert(rows.end(), {row, row + 1, row + 2});
    }
    const ConstPanelMap values = columnsOf(panel);
    for (Index column = 0; column < values.cols(); ++column) {
      columns.rows.insert(columns.rows.end(), rows.begin() + column, rows.end());
      columns.values.insert(columns.values.end(), values.col(column).data() + column,
                            values.col(column).data() + values.rows());
      columns.starts.push_back(static_cast<int>(columns.rows.size()));
    }
  }
  return columns;
}

}  // namespace omega_slam::graph

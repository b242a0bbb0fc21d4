#include "omega_slam/graph/elimination_plan.h"

// CHOLMOD's header before Eigen's wrapper, which expects it.
#include <cholmod.h>

#include <Eigen/CholmodSupport>
#include <algorithm>
#include <utility>

namespace omega_slam::graph {

namespace {

using Pattern = Eigen::SparseMatrix<double>;
using Eigen::VectorXi;

/// The place of each node.
VectorXi orderByMinimumDegree(const Pattern& blocks) {
  cholmod_common common{};
  cholmod_start(&common);
  // A view, not a copy; CHOLMOD does not write to it.
  cholmod_sparse view = Eigen::viewAsCholmod(blocks.selfadjointView<Eigen::Lower>());
  VectorXi order(blocks.cols());
  cholmod_amd(&view, nullptr, 0, order.data(), &common);
  cholmod_finish(&common);
  VectorXi place(order.size());
  for (int i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
  }
  return place;
}

/// For each node some of those that it shares a block with, by places.
struct Neighbours {
  VectorXi starts;
  VectorXi nodes;

  [[nodiscard]] auto of(int node) const {
    return nodes.segment(starts[node], starts[node + 1] - starts[node]);
  }
};

enum class Side { kEarlier, kLater };

Neighbours neighbours(const Pattern& blocks, const VectorXi& place, Side side) {
  Neighbours found{VectorXi::Zero(place.size() + 1), VectorXi(blocks.nonZeros() - place.size())};
  const auto forEachTie = [&](auto act) {
    for (int column = 0; column < blocks.cols(); ++column) {
      for (Pattern::InnerIterator block(blocks, column); block; ++block) {
        if (block.row() != column) {
          const auto [earlier, later] = std::minmax({place[column], place[block.row()]});
          side == Side::kEarlier ? act(later, earlier) : act(earlier, later);
        }
      }
    }
  };
  forEachTie([&](int node, int) { ++found.starts[node + 1]; });
  for (int node = 0; node < place.size(); ++node) {
    found.starts[node + 1] += found.starts[node];
  }
  VectorXi next = found.starts;
  forEachTie([&](int node, int other) { found.nodes[next[node]++] = other; });
  return found;
}

/// Of each place the first later one that its elimination touches; -1 for none (Davis,
/// section 4.1).
VectorXi eliminationTree(const Neighbours& earlier) {
  const auto size = static_cast<int>(earlier.starts.size()) - 1;
  VectorXi parents = VectorXi::Constant(size, -1);
  VectorXi ancestors = parents;  // shortcuts
  for (int column = 0; column < size; ++column) {
    const auto rows = earlier.of(column);
    for (int i = 0; i < rows.size(); ++i) {
      int node = rows[i];
      while (node != -1 && node < column) {
        const int next = std::exchange(ancestors[node], column);
        if (next == -1) {
          parents[node] = column;
        }
        node = next;
      }
    }
  }
  return parents;
}

/// A place for each node of a tree: children just before their parents, else in the order as it
/// was.
VectorXi postorder(const VectorXi& parents) {
  const auto size = static_cast<int>(parents.size());
  VectorXi branch = VectorXi::Ones(size);  // nodes in it
  for (int node = 0; node < size; ++node) {
    if (parents[node] != -1) {
      branch[parents[node]] += branch[node];
    }
  }
  VectorXi place(size);
  VectorXi end_for_children(size);
  int end_for_roots = size;
  for (int node = size - 1; node >= 0; --node) {
    int& end = parents[node] == -1 ? end_for_roots : end_for_children[parents[node]];
    place[node] = end_for_children[node] = end - 1;
    end -= branch[node];
  }
  return place;
}

/// Finds the factor's pattern column by column, and puts columns together that are alike.
class PanelMaker {
 public:
  /// @param later,parents in an order that is a postorder of the tree
  PanelMaker(const Neighbours& later, const VectorXi& parents)
      : later_(later),
        parents_(parents),
        seen_by_(VectorXi::Constant(parents.size(), kNone)),
        first_child_(seen_by_),
        next_child_(seen_by_) {}

  [[nodiscard]] std::vector<Panel> make() {
    for (int column = 0; column < parents_.size(); ++column) {
      std::vector<int> rows = rowsOf(column);
      if (!mergesInto(column, rows.size())) {
        panels_.push_back({});
        panels_.back().first = column;
        zeros_ = 0.0;
      }
      ++panels_.back().count;
      panels_.back().rows = std::move(rows);
      hangOn(parents_[column]);
    }
    return std::move(panels_);
  }

 private:
  static constexpr int kNone = -1;

  /// The later rows of Omega's column, and those of the panels that hang on it.
  [[nodiscard]] std::vector<int> rowsOf(int column) {
    std::vector<int> rows;
    const auto take = [&](int row) {
      if (row != column && std::exchange(seen_by_[row], column) != column) {
        rows.push_back(row);
      }
    };
    const auto tied = later_.of(column);
    std::for_each(tied.data(), tied.data() + tied.size(), take);
    for (int child = first_child_[column]; child != kNone; child = next_child_[child]) {
      const std::vector<int>& others = panels_[static_cast<std::size_t>(child)].rows;
      std::for_each(others.begin(), others.end(), take);
    }
    return rows;
  }

  /// Whether a column shall become the next one of the last panel. Shares of zeros after CHOLMOD's.
  [[nodiscard]] bool mergesInto(int column, std::size_t rows) {
    if (column == 0 || parents_[column - 1] != column) {
      return false;
    }
    const Panel& panel = panels_.back();
    const double width = panel.count + 1;
    const auto height = static_cast<double>(rows);
    const double more = height + 1.0 - static_cast<double>(panel.rows.size());
    const double zeros = zeros_ + panel.count * more;
    const double share = width <= 2 ? 0.4 : width <= 5 ? 0.2 : 0.05;
    if (zeros > share * width * (0.5 * (width + 1.0) + height)) {
      return false;
    }
    zeros_ = zeros;
    return true;
  }

  void hangOn(int column) {
    if (column != kNone) {
      const auto panel = static_cast<int>(panels_.size()) - 1;
      next_child_[panel] = std::exchange(first_child_[column], panel);
    }
  }

  const Neighbours& later_;
  const VectorXi& parents_;
  VectorXi seen_by_;
  VectorXi first_child_;  ///< by column, the panels that hang on it
  VectorXi next_child_;   ///< by panel
  std::vector<Panel> panels_;
  double zeros_{0.0};  ///< blocks of the last panel that need not be there
};

/// Where a parent has the rows of its child.
std::vector<int> rowsInParent(const std::vector<int>& rows, const Panel& parent) {
  std::vector<int> places;
  places.reserve(rows.size());
  auto row = rows.begin();
  for (; row != rows.end() && *row < parent.first + parent.count; ++row) {
    places.push_back(*row - parent.first);
  }
  auto known = parent.rows.begin();
  for (; row != rows.end(); ++row) {
    known = std::find(known, parent.rows.end(), *row);
    places.push_back(parent.count + static_cast<int>(known - parent.rows.begin()));
  }
  return places;
}

}  // namespace

int Panel::nodeOf(int row) const {
  return row < count ? first + row : rows[static_cast<std::size_t>(row - count)];
}

int Panel::rowOf(int node) const {
  if (node < first + count) {
    return node - first;
  }
  const auto row = std::lower_bound(rows.begin(), rows.end(), node);
  return count + static_cast<int>(row - rows.begin());
}

EliminationPlan::EliminationPlan(const Pattern& blocks) : place(orderByMinimumDegree(blocks)) {
  const VectorXi tree = eliminationTree(neighbours(blocks, place, Side::kEarlier));
  const VectorXi walk = postorder(tree);
  VectorXi parents = VectorXi::Constant(tree.size(), -1);
  for (int node = 0; node < tree.size(); ++node) {
    if (tree[node] != -1) {
      parents[walk[node]] = walk[tree[node]];
    }
  }
  place = place.unaryExpr([&](int node) { return walk[node]; }).eval();
  panels = PanelMaker(neighbours(blocks, place, Side::kLater), parents).make();
  tiePanels();
}

void EliminationPlan::tiePanels() {
  panel_of.resize(place.size());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    panel_of.segment(panels[i].first, panels[i].count).setConstant(static_cast<int>(i));
  }
  for (Panel& panel : panels) {
    std::sort(panel.rows.begin(), panel.rows.end());
    panel.first_element = elements;
    elements += 9 * panel.count * panel.height();
  }
  for (Panel& panel : panels) {
    if (!panel.rows.empty()) {
      panel.parent = panel_of[panel.rows.front()];
      panel.in_parent = rowsInParent(panel.rows, panels[static_cast<std::size_t>(panel.parent)]);
    }
  }
}

}  // namespace omega_slam::graph

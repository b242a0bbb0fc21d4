#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace omega_slam::graph {

/// Nodes that are eliminated together, since their columns of the factor have the same rows: a
/// dense panel of the factor, with their own rows first and those of later nodes below. Nodes are
/// known by their places in the order of elimination.
struct Panel {
  int first{0};                   ///< node
  int count{0};                   ///< of nodes
  int parent{-1};                 ///< panel of the first of `rows`; -1 without any
  std::vector<int> rows;          ///< later nodes, ascending
  std::vector<int> in_parent;     ///< which rows of the parent these are
  Eigen::Index first_element{0};  ///< of the panel, among those of all

  [[nodiscard]] int height() const { return count + static_cast<int>(rows.size()); }  ///< nodes
  [[nodiscard]] int nodeOf(int row) const;                                            ///< in nodes
  [[nodiscard]] int rowOf(int node) const;  ///< @pre the panel has it
};

/// In which order nodes are eliminated from Omega, and what the factor looks like then. Both depend
/// on the pattern alone.
///
/// The order is that of approximate minimum degree (Amestoy, Davis and Duff, "Algorithm 837: AMD",
/// TOMS 30, 2004) on the graph of the nodes: it is nine times smaller than that of the rows, and no
/// worse a guide. Within it, the elimination tree is walked in postorder, so that a panel's
/// children come just before it (Davis, "Direct Methods for Sparse Linear Systems", 2006, chapter
/// 4). Panels are merged where that adds few zeros (Ashcraft and Grimes, "The influence of relaxed
/// supernode partitions on the multifrontal method", TOMS 15, 1989): wide ones are quicker for
/// their size.
struct EliminationPlan {
  /// @param blocks which nodes share a block of Omega: lower triangle, with the diagonal
  explicit EliminationPlan(const Eigen::SparseMatrix<double>& blocks);

  Eigen::VectorXi place;      ///< of each node in the order
  std::vector<Panel> panels;  ///< children before their parents
  Eigen::VectorXi panel_of;   ///< by place
  Eigen::Index elements{0};   ///< of all panels

 private:
  void tiePanels();
};

}  // namespace omega_slam::graph

#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "omega_slam/graph/information_form.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/sparse_cholesky.h"

namespace omega_slam::graph {

/// Omega and xi of a graph with their factorisation. What does not depend on the poses, the
/// pattern, its ordering and the symbolic factorisation, is kept while the same nodes are tied
/// together.
class GraphSystem {
 public:
  /// @param held nodes that do not move
  void prepare(const PoseGraph& graph, const std::vector<NodeId>& held);

  [[nodiscard]] InformationForm& form() { return *form_; }

  /// Factorises Omega and solves. @return none where Omega is not positive definite
  [[nodiscard]] std::optional<Eigen::VectorXd> solve();

  /// Solves for any right side with the last factorisation.
  [[nodiscard]] Eigen::VectorXd solveFor(const Eigen::VectorXd& right) const {
    return cholesky_->solve(right);
  }

  [[nodiscard]] const std::vector<NodeId>& held() const { return held_; }

  /// The last factorisation.
  [[nodiscard]] const SparseCholesky& cholesky() const { return *cholesky_; }

  [[nodiscard]] int factorizations() const { return factorizations_; }  ///< since prepare()

 private:
  std::vector<std::pair<NodeId, NodeId>> ties_;
  std::vector<NodeId> held_;
  std::size_t nodes_{0};
  std::optional<InformationForm> form_;
  std::unique_ptr<SparseCholesky> cholesky_;
  int factorizations_{0};
};

}  // namespace omega_slam::graph

#include "omega_slam/graph/loop_examination.h"

#include "omega_slam/graph/descent.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/selected_inverse.h"

namespace omega_slam::graph {

std::optional<std::vector<LoopFit>> examine(const PoseGraph& graph, const Weighing& weighing,
                                            GraphSystem& system,
                                            const std::vector<std::size_t>& loops) {
  fillForm(graph, weighing, system.form());
  if (!system.solve()) {
    return std::nullopt;
  }
  const SelectedInverse inverse(system.cholesky().columns());
  std::vector<bool> is_held(graph.poses.size(), false);
  for (const NodeId node : system.held()) {
    is_held[node] = true;
  }
  const auto blockOf = [&](NodeId a, NodeId b) -> Eigen::Matrix3d {
    return is_held[a] || is_held[b] ? Eigen::Matrix3d::Zero().eval() : inverse.block(a, b);
  };
  std::vector<LoopFit> fits;
  fits.reserve(loops.size());
  for (const std::size_t k : loops) {
    const Constraint& loop = graph.constraints[k];
    const LinearizedConstraint at = linearize(loop, graph);
    const Eigen::Matrix3d across = at.J_from * blockOf(loop.from, loop.to) * at.J_to.transpose();
    const Eigen::Matrix3d covariance =
        at.J_from * blockOf(loop.from, loop.from) * at.J_from.transpose() +
        at.J_to * blockOf(loop.to, loop.to) * at.J_to.transpose() + across + across.transpose();
    const double weight = weighing.at(k, at.error.dot(loop.information * at.error)).weight;
    fits.push_back(fitOf(loop, at.error, covariance, weight > 0.0));
  }
  return fits;
}

}  // namespace omega_slam::graph

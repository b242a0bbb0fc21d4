#include "omega_slam/graph/marginals.h"

#include "omega_slam/graph/descent.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/topology.h"

namespace omega_slam::graph {

using geometry::Pose2;

Marginals::Marginals(const PoseGraph& graph, const KernelConfig& kernels)
    : poses_(graph.poses), is_held_(graph.poses.size(), false) {
  const auto held = spanningForest(graph).roots;
  for (const NodeId node : held) {
    is_held_[node] = true;
  }
  system_.prepare(graph, held);
  fillForm(graph, Weighing(kernels, graph), system_.form());
  is_valid_ = system_.solve().has_value();
}

Marginals::Columns Marginals::columns(NodeId node) const {
  Columns columns = Columns::Zero(static_cast<Eigen::Index>(3 * poses_.size()), 3);
  if (is_held_[node]) {
    return columns;
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto row = 3 * static_cast<Eigen::Index>(node) + axis;
    columns.col(axis) = system_.solveFor(Eigen::VectorXd::Unit(columns.rows(), row));
  }
  return columns;
}

Eigen::Matrix3d Marginals::covariance(NodeId node) const {
  const Eigen::Matrix3d block = columns(node).middleRows<3>(3 * static_cast<Eigen::Index>(node));
  return 0.5 * (block + block.transpose());
}

Eigen::Matrix<double, 6, 6> Marginals::jointCovariance(NodeId a, NodeId b) const {
  const Columns of_a = columns(a);
  const Columns of_b = columns(b);
  const auto row_a = 3 * static_cast<Eigen::Index>(a);
  const auto row_b = 3 * static_cast<Eigen::Index>(b);
  Eigen::Matrix<double, 6, 6> joint;
  joint << of_a.middleRows<3>(row_a), of_b.middleRows<3>(row_a),  //
      of_a.middleRows<3>(row_b), of_b.middleRows<3>(row_b);
  return 0.5 * (joint + joint.transpose());
}

Eigen::Matrix3d Marginals::relativeCovariance(NodeId a, NodeId b) const {
  // The error of a constraint whose measurement has the axes of `a`.
  Constraint unturned;
  unturned.from = a;
  unturned.to = b;
  const LinearizedConstraint at = linearize(unturned, poses_[a], poses_[b]);
  Eigen::Matrix<double, 3, 6> jacobian;
  jacobian << at.J_from, at.J_to;
  return jacobian * jointCovariance(a, b) * jacobian.transpose();
}

}  // namespace omega_slam::graph

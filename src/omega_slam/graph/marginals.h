#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "omega_slam/graph/graph_system.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/weighing.h"

namespace omega_slam::graph {

/// How well poses are known: covariances of single poses and of pairs, as columns of Omega^-1 found
/// by solving for them, three a pose, with one factorisation. The inverse itself, which is dense,
/// is never made.
///
/// Covariances are those of (x, y, theta) in the map's axes [m^2, m rad, rad^2], given the held
/// nodes: a held pose has none.
class Marginals {
 public:
  /// Factorises Omega at the graph's poses, which should be the solution.
  explicit Marginals(const PoseGraph& graph, const KernelConfig& kernels = {});

  /// Whether Omega is positive definite. Nothing below may be asked for where it is not.
  [[nodiscard]] bool isValid() const { return is_valid_; }

  /// O(elements of the factor) each.
  [[nodiscard]] Eigen::Matrix3d covariance(NodeId node) const;

  /// Of both poses together: rows of `a`, then rows of `b`.
  [[nodiscard]] Eigen::Matrix<double, 6, 6> jointCovariance(NodeId a, NodeId b) const;

  /// Of `T_a_b` as additive errors of (x, y, theta) in the axes of `a`. What a new constraint
  /// between the two is gated by.
  [[nodiscard]] Eigen::Matrix3d relativeCovariance(NodeId a, NodeId b) const;

 private:
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  [[nodiscard]] Columns columns(NodeId node) const;

  std::vector<geometry::Pose2> poses_;
  std::vector<bool> is_held_;
  GraphSystem system_;
  bool is_valid_{false};
};

}  // namespace omega_slam::graph

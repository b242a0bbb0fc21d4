#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::graph {

/// Index of a node in the graph: keyframes are numbered 0, 1, 2, ... in the order of their making.
using NodeId = std::uint32_t;

enum class ConstraintKind : std::uint8_t {
  kOdometry = 0,  ///< from the wheels
  kMatch = 1,     ///< from scan matching with the keyframes just before
  kLoop = 2,      ///< from scan matching with an earlier visit
  kLandmark = 3   ///< a landmark seen from a keyframe
};

[[nodiscard]] std::string toString(ConstraintKind kind);

/// What one measurement says of the relative pose of two nodes.
struct Constraint {
  NodeId from{0};
  NodeId to{0};
  geometry::Pose2 T_from_to;  ///< measured pose of `to` seen from `from`
  /// Information (inverse covariance) of the error (x, y, theta) of `T_from_to`, in the axes of
  /// `to` as measured: the convention of g2o [1/m^2, 1/(m rad), 1/rad^2]: symmetric, positive
  /// semi-definite.
  Eigen::Matrix3d information{Eigen::Matrix3d::Identity()};
  ConstraintKind kind{ConstraintKind::kOdometry};
  double confidence{1.0};  ///< [0, 1], of the matcher; 1 for odometry
};

/// Why a constraint can't enter a graph of so many nodes, a short stable phrase; empty if it can.
[[nodiscard]] std::string faultOf(const Constraint& constraint, std::size_t nodes);

/// Poses to be estimated and the constraints between them. Node i's pose is `poses[i]`, `T_map_i`.
struct PoseGraph {
  std::vector<geometry::Pose2> poses;
  std::vector<Constraint> constraints;
  std::vector<NodeId> held;    ///< nodes that a solver does not move; node 0 where there are none
  std::vector<NodeId> points;  ///< nodes without a heading, such as landmarks
};

}  // namespace omega_slam::graph

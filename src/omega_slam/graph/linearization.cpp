#include "omega_slam/graph/linearization.h"

#include "omega_slam/geometry/angle.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

/// What error and Jacobians are made of.
struct Relation2 {
  Eigen::Matrix2d to_measurement;  ///< from the axes of `from` to those of the measurement
  Eigen::Matrix2d both;            ///< from the map's axes to those of the measurement
  Eigen::Vector2d offset;          ///< [m] of `to` in the axes of `from`
  Eigen::Vector3d error;
};

Relation2 relate(const Pose2& measured, const Pose2& from, const Pose2& to) {
  Relation2 result;
  const Eigen::Matrix2d to_from = from.rotation().transpose();
  result.to_measurement = measured.rotation().transpose();
  result.both = result.to_measurement * to_from;
  result.offset = to_from * (to.translation() - from.translation());
  result.error.head<2>() = result.to_measurement * (result.offset - measured.translation());
  result.error[2] =
      geometry::angleDifference(geometry::angleDifference(to.theta, from.theta), measured.theta);
  return result;
}

}  // namespace

LinearizedConstraint linearize(const Constraint& constraint, const Pose2& T_map_from,
                               const Pose2& T_map_to) {
  const Relation2 at = relate(constraint.T_from_to, T_map_from, T_map_to);
  LinearizedConstraint result;
  result.error = at.error;
  result.J_from.setZero();
  result.J_from.topLeftCorner<2, 2>() = -at.both;
  // Turning `from` by a positive angle turns what it sees the other way.
  result.J_from.topRightCorner<2, 1>() =
      at.to_measurement * Eigen::Vector2d(at.offset.y(), -at.offset.x());
  result.J_from(2, 2) = -1.0;
  result.J_to.setZero();
  result.J_to.topLeftCorner<2, 2>() = at.both;
  result.J_to(2, 2) = 1.0;
  return result;
}

LinearizedConstraint linearize(const Constraint& constraint, const PoseGraph& graph) {
  return linearize(constraint, graph.poses[constraint.from], graph.poses[constraint.to]);
}

Eigen::Vector3d errorOf(const Constraint& constraint, const PoseGraph& graph) {
  return relate(constraint.T_from_to, graph.poses[constraint.from], graph.poses[constraint.to])
      .error;
}

double chiSquare(const PoseGraph& graph, const Constraint& constraint) {
  const Eigen::Vector3d error = errorOf(constraint, graph);
  return error.dot(constraint.information * error);
}

double chiSquare(const PoseGraph& graph) {
  double sum = 0.0;
  for (const Constraint& constraint : graph.constraints) {
    sum += chiSquare(graph, constraint);
  }
  return sum;
}

}  // namespace omega_slam::graph

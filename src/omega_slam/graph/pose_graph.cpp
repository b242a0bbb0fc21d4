#include "omega_slam/graph/pose_graph.h"

#include "omega_slam/geometry/covariance.h"

namespace omega_slam::graph {

std::string toString(ConstraintKind kind) {
  switch (kind) {
    case ConstraintKind::kOdometry:
      return "odometry";
    case ConstraintKind::kMatch:
      return "match";
    case ConstraintKind::kLoop:
      return "loop";
    case ConstraintKind::kLandmark:
      return "landmark";
  }
  return "unknown";
}

std::string faultOf(const Constraint& constraint, std::size_t nodes) {
  if (constraint.from >= nodes || constraint.to >= nodes) {
    return "constraint names an unknown node";
  }
  if (constraint.from == constraint.to) {
    return "constraint ties a node to itself";
  }
  if (!constraint.T_from_to.isFinite()) {
    return "constraint's pose is not finite";
  }
  if (!geometry::isPositiveSemidefinite(constraint.information)) {
    return "constraint's information is not finite, symmetric and positive";
  }
  if (constraint.information.trace() <= 0.0) {
    return "constraint's information is zero";
  }
  return {};
}

}  // namespace omega_slam::graph

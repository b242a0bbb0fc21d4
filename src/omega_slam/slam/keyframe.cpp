#include "omega_slam/slam/keyframe.h"

#include <Eigen/LU>

namespace omega_slam::slam {

graph::Constraint matchConstraint(graph::NodeId from, graph::NodeId to,
                                  const matching::MatchResult& match, graph::ConstraintKind kind) {
  graph::Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.T_from_to = match.T_reference_scan;
  const Eigen::Matrix3d information = match.covariance.inverse();
  constraint.information = 0.5 * (information + information.transpose());
  constraint.kind = kind;
  constraint.confidence = match.confidence;
  return constraint;
}

}  // namespace omega_slam::slam

#include "omega_slam/slam/keyframe.h"

#include <Eigen/LU>
#include <algorithm>

#include "omega_slam/geometry/covariance.h"

namespace omega_slam::slam {

graph::NodeId beginOfNewest(graph::NodeId count, const Keyframe& newest) {
  return std::max(newest.stretch, newest.id >= count ? newest.id - count + 1 : 0);
}

matching::View viewOf(const sensing::Sweep& sweep) {
  return {sweep.returns(), sweep.T_base_laser.translation()};
}

graph::Constraint matchConstraint(graph::NodeId from, graph::NodeId to,
                                  const matching::MatchResult& match, graph::ConstraintKind kind) {
  graph::Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.T_from_to = match.T_reference_scan;
  // The matcher speaks in the axes of the reference, the graph in those of the scan.
  const Eigen::Matrix3d information =
      geometry::rotateCovariance(match.covariance, -match.T_reference_scan.theta).inverse();
  constraint.information = 0.5 * (information + information.transpose());
  constraint.kind = kind;
  constraint.confidence = match.confidence;
  return constraint;
}

}  // namespace omega_slam::slam

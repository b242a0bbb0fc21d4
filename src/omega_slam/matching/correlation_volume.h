#pragma once

#include <Eigen/Core>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/correlative_search.h"

namespace omega_slam::matching {

/// A covariance made wider wherever the correlation volume around the pose is: the second moments
/// of the poses there about it, each weighted with its likelihood (Olson 2009, section III-D). The
/// covariance tells where to look: along its axes, three deviations to each side, and farther
/// along an axis on which the scores are flat. Scores are sums over points that err together; they
/// are weighted as if the scan had only a few dozen points.
///
/// @param pose       a peak, `T_reference_scan`
/// @param covariance of (x, y, theta) as it is believed to be, positive definite
/// @param deviation  [m] standard deviation of a point's distance from its surface
/// @return not less than `covariance` in any direction
[[nodiscard]] Eigen::Matrix3d widenByVolume(const CorrelativeSearch& search,
                                            const geometry::Pose2& pose,
                                            const Eigen::Matrix3d& covariance, double deviation);

}  // namespace omega_slam::matching

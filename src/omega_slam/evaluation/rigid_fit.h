#pragma once

#include <Eigen/Core>
#include <vector>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::evaluation {

/// The same point in two frames, a and b.
struct PointPair {
  Eigen::Vector2d p_a;
  Eigen::Vector2d p_b;
};

/// `T_b_a` that minimises the sum of squared distances between `T_b_a * p_a` and `p_b` (Umeyama,
/// "Least-squares estimation of transformation parameters between two point patterns", PAMI 1991,
/// without the scale). In the plane the best rotation has a closed form: the direction of the
/// summed products of centred points, taken as complex numbers.
/// @param otherwise [rad] the rotation where points within a millimetre or so of each other tell
/// none
[[nodiscard]] geometry::Pose2 fitRigidMotion(const std::vector<PointPair>& pairs,
                                             double otherwise = 0.0);

}  // namespace omega_slam::evaluation

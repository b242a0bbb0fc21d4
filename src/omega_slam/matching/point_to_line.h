#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/scan_matcher.h"
#include "omega_slam/matching/surface_model.h"

namespace omega_slam::matching {

/// How much the distance of a point from its partner counts.
struct DistanceKernel {
  double reach{0.1};       ///< [m] farther partners are none
  double deviation{0.02};  ///< [m] standard deviation of a range
  double tolerance{0.04};  ///< [m] Cauchy's constant: a point so far off counts half

  /// [1/m^2] of a point so far off.
  [[nodiscard]] double weightAt(double squared_distance) const {
    const double squared = tolerance * tolerance;
    return squared / ((squared + squared_distance) * deviation * deviation);
  }
};

/// The distances of a scan's points from a reference around a pose, as Gauss and Newton see them:
/// a change d of (x, y, theta) changes their weighted sum of squares by d^T matrix d - 2 vector^T
/// d.
struct PointToLineEquations {
  Eigen::Matrix3d matrix{Eigen::Matrix3d::Zero()};   ///< J^T W J
  Eigen::Vector3d vector{Eigen::Vector3d::Zero()};   ///< -J^T W r
  Eigen::Matrix3d certain{Eigen::Matrix3d::Zero()};  ///< the part of `matrix` to build on

  /// Adds a point by its distance to the line of its partner (the metric of Censi 2008, "An ICP
  /// variant using a point-to-line metric"), in units of the range's deviation, with Cauchy's
  /// weight against outliers; where there is no line, by its distance to the partner itself.
  /// @param gap [m] from the partner to the point
  /// @param arm [m] from the scan's origin to the point; both in the reference's axes
  void add(const Surface& surface, const Eigen::Vector2d& gap, const Eigen::Vector2d& arm,
           const DistanceKernel& kernel);
};

/// The equations of those points that have a partner within reach, whose side the scan could see.
/// O(points).
[[nodiscard]] PointToLineEquations linearize(SurfaceModel& reference, const SomePoints& scan,
                                             const geometry::Pose2& T_reference_scan,
                                             const DistanceKernel& kernel);
[[nodiscard]] inline PointToLineEquations linearize(SurfaceModel& reference, const View& scan,
                                                    const geometry::Pose2& T_reference_scan,
                                                    const DistanceKernel& kernel) {
  return linearize(reference, SomePoints{scan}, T_reference_scan, kernel);
}

/// The step (x, y, theta) to the least squares, along the directions that the points determine.
///
/// An open direction leads back to the guess instead (Zhang, Kaess and Singh 2016, "On degeneracy
/// of optimization-based state estimation problems", ICRA): else the pose would drift along a
/// corridor to wherever the points of the walls happen to overlap. What is open says the certain
/// part of the matrix.
///
/// @param pose around which the equations are
/// @return zero where the points are so far away that numbers fail
[[nodiscard]] Eigen::Vector3d stepToLeastSquares(const PointToLineEquations& equations,
                                                 const geometry::Pose2& pose,
                                                 const geometry::Pose2& guess);

struct PointToLineConfig {
  int max_iterations{10};
  double reach{0.1};         ///< [m] farther partners are none
  double range_noise{0.02};  ///< [m] standard deviation of a range
};

/// Carries a pose that is nearly right the last centimetres, by Gauss-Newton steps.
///
/// Point-to-point matching ties a point to a neighbour's place on the wall and may lock a beam off;
/// along a wall this metric is free. Along directions that no line determines the pose stays where
/// it was.
///
/// @return `T_reference_scan`; the guess where nothing is within reach
[[nodiscard]] geometry::Pose2 refinePointToLine(SurfaceModel& reference, const View& scan,
                                                const geometry::Pose2& guess,
                                                const PointToLineConfig& config);

}  // namespace omega_slam::matching

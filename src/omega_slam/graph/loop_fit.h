#pragma once

#include <Eigen/Core>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// How a loop fits what is known without it: the innovation, with the covariance that it should
/// have if the loop is right, that of the loop's error and of the prediction together.
struct LoopFit {
  /// Squared Mahalanobis length of the innovation. Of a right loop, chi-square with 3 degrees of
  /// freedom.
  double squared{0.0};
  /// Square root of the determinant of the innovation's covariance [m^2 rad].
  double spread{0.0};
  /// Whether anything is known without the loop. A loop that alone ties two parts together has no
  /// innovation: `squared` is 0, `spread` infinite.
  bool is_testable{true};
};

/// Volume of errors among which false loops scatter evenly [m^2 rad]: how far they may claim to be
/// off, in x, in y and in heading.
struct ErrorSpace {
  double volume{1.0};

  /// That of a map: its bounding box, at least a square metre, and all headings.
  [[nodiscard]] static ErrorSpace of(const std::vector<geometry::Pose2>& poses);
};

/// How often a false loop would fit as well as this one does: the share of the space that the
/// ellipsoid of equal `squared` takes. Says something where `squared` alone does not: with a vague
/// prediction, false loops fit as well as right ones. Does not depend on whether covariances are
/// all too large or too small by the same factor.
[[nodiscard]] double chanceOf(const LoopFit& fit, const ErrorSpace& space);

/// Density of the innovation if the loop is right, normal, over that if it is false, even: the
/// factor by which the fit changes the odds for the loop.
/// @param variance factor of all covariances
[[nodiscard]] double oddsOf(const LoopFit& fit, const ErrorSpace& space, double variance = 1.0);

/// Fit of a loop to poses of which the relative covariance is known.
/// @param covariance of the loop's error as linearize() defines it, by the poses' uncertainty
/// @param is_counted whether the loop is among what the poses follow from. If so, the fit is to
/// what they would be without it: e^T Omega (I - S Omega)^-1 e for the error e and its covariance S
/// at the solution with it, Baarda's test ("A testing procedure for use in geodetic networks",
/// 1968, section 3), with no need to solve without it.
[[nodiscard]] LoopFit fitOf(const Constraint& loop, const Eigen::Vector3d& error,
                            const Eigen::Matrix3d& covariance, bool is_counted);

/// Fit of a new loop to a graph: the gate of a front end is `fit.squared` below its square.
/// @param relative_covariance Marginals::relativeCovariance(loop.from, loop.to)
[[nodiscard]] LoopFit fitOfNewLoop(const PoseGraph& graph, const Constraint& loop,
                                   const Eigen::Matrix3d& relative_covariance);

}  // namespace omega_slam::graph

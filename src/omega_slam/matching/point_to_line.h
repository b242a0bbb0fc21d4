#pragma once

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/scan_matcher.h"
#include "omega_slam/matching/surface_model.h"

namespace omega_slam::matching {

struct PointToLineConfig {
  int max_iterations{10};
  double reach{0.1};         ///< [m] farther partners are none
  double range_noise{0.02};  ///< [m] standard deviation of a range
};

/// Carries a pose that is nearly right the last centimetres: Gauss-Newton on the distances of the
/// scan's points to the lines of the reference (the metric of Censi 2008, "An ICP variant using a
/// point-to-line metric", minimised by steps instead of in closed form), with Cauchy weights
/// against outliers.
///
/// Point-to-point matching ties a point to a neighbour's place on the wall and may lock a beam off;
/// along a wall this metric is free. Along directions that no line determines the pose stays where
/// it was, by a weak prior.
///
/// @return `T_reference_scan`; the guess where nothing is within reach
[[nodiscard]] geometry::Pose2 refinePointToLine(SurfaceModel& reference, const Points& scan,
                                                const geometry::Pose2& guess,
                                                const PointToLineConfig& config);

}  // namespace omega_slam::matching

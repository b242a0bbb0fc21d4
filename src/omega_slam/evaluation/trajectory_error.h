#pragma once

#include <cstddef>

#include "omega_slam/evaluation/error_statistics.h"
#include "omega_slam/geometry/pose2.h"

namespace omega_slam::evaluation {

/// Absolute trajectory error of an estimate, after the rigid motion that fits it best to the truth.
struct TrajectoryError {
  std::size_t matched{0};       ///< poses of the estimate for whose stamps the truth is known
  std::size_t unmatched{0};     ///< the others; they count not
  geometry::Pose2 T_truth_map;  ///< the fit: where the estimate's frame lies in the truth's
  ErrorStatistics translation;  ///< [m]
  ErrorStatistics rotation;     ///< [rad]
};

/// Compares by stamps: the truth is interpolated to the stamp of each pose of the estimate.
///
/// The fit minimises the sum of squared distances over SE(2) (Umeyama, "Least-squares estimation of
/// transformation parameters between two point patterns", PAMI 1991, without the scale). Where the
/// positions do not tell a rotation, because the robot stood still, the headings do.
///
/// @param estimate `T_map_base`, finite, as is the truth
/// @param truth `T_truth_base`, in any order of time
/// @param max_gap [s] the truth counts as known between two of its poses if they are no farther
/// apart than this; >= 0
[[nodiscard]] TrajectoryError absoluteTrajectoryError(const geometry::Trajectory& estimate,
                                                      const geometry::Trajectory& truth,
                                                      double max_gap = 0.5);

}  // namespace omega_slam::evaluation

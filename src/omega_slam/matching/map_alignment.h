#pragma once

#include <Eigen/Core>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/local_map.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// How a scan lies on one grid of a map, to first order around a pose: residuals
/// r_i = 1 - M(T_map_scan * p_i), and J_i the derivative of M(T_map_scan * p_i) by (x, y, theta).
struct MapLinearization {
  double squared_residuals{0.0};
  Eigen::Matrix3d hessian{Eigen::Matrix3d::Zero()};  ///< sum of J_i^T J_i
  Eigen::Vector3d descent{Eigen::Vector3d::Zero()};  ///< sum of J_i^T r_i
};

/// Kohlbrecher et al. 2011, equations 4 to 14; M is interpolated bilinearly between the centres of
/// the cells. Outside of the map it is 0.
/// @param level of the map, 0 is the finest
/// @param scan finite
[[nodiscard]] MapLinearization linearize(const LocalMap& map, std::size_t level, const Points& scan,
                                         const geometry::Pose2& T_map_scan);

struct MapAlignment {
  geometry::Pose2 T_map_scan;
  bool converged{false};  ///< on the finest grid, before the iterations ran out
};

/// Lays a scan on a map: Gauss-Newton on the sum of (1 - M)^2, grid after grid from the coarsest to
/// the finest (the paper, section IV).
///
/// Deviations from the paper. A step is not taken before it has been seen to help: if the scan
/// would lie worse, it is halved. A step is no longer than the grid can see. And on each grid the
/// pose is held where it began by a prior of a few centimetres, against hundreds of points: what
/// many points agree on is hardly felt, but where next to nothing does, as along a corridor, the
/// noise of the grid does not lead astray.
///
/// @param scan, guess finite
/// @param max_iterations on each grid
[[nodiscard]] MapAlignment alignToMap(const LocalMap& map, const Points& scan,
                                      const geometry::Pose2& guess, int max_iterations);

}  // namespace omega_slam::matching

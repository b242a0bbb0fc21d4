#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::evaluation {

/// Where control points lay one map on the other.
struct FeatureAlignment {
  std::optional<geometry::Pose2> T_truth_map;  ///< the built map's frame in the true map's frame
  std::string reason;                          ///< why there is none, one sentence
  std::size_t built_points{0};                 ///< control points in the built map
  std::size_t truth_points{0};                 ///< and in the true one
  std::size_t matches{0};                      ///< pairs of points that look alike
  std::size_t inliers{0};                      ///< pairs that agree on the alignment
};

/// Whether OpenCV has SIFT: from 4.4 on. Older ones keep it in a module that is not free.
[[nodiscard]] bool hasControlPoints();

/// Lays a built map on the true one as the paper does (section 7.3): by SIFT control points of the
/// maps as images (Lowe, "Distinctive Image Features from Scale-Invariant Keypoints", IJCV 2004),
/// pairs of which are chosen by RANSAC; the rigid motion is then fitted to the chosen ones by least
/// squares (Umeyama, PAMI 1991). It needs no first guess, and fails on maps that are poor: then
/// there is a reason. Deterministic.
///
/// Deviations: the resolutions are known, so a pair of images that agree on another scale than 1
/// (by more than a twentieth) is refused.
[[nodiscard]] FeatureAlignment alignByFeatures(const grid::OccupancyGrid& built,
                                               const grid::OccupancyGrid& truth);

}  // namespace omega_slam::evaluation

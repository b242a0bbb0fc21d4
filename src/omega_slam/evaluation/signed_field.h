#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::evaluation {

/// What a map says at a point: positive in walls, negative in the open, 0 where it is unknown.
struct SignedPoint {
  Eigen::Vector2d point;  ///< [m] in the frame of the map
  double value{0.0};
};

/// The cells of a map that are known, as points: walls sum up to +1, open cells to -1. At most
/// `most_open` open cells, evenly chosen, stand for all of them. Without walls or without open
/// cells that half is missing.
[[nodiscard]] std::vector<SignedPoint> signedPoints(const grid::OccupancyGrid& map,
                                                    std::size_t most_open);

/// A map as a smooth function of the plane.
class SignedField {
 public:
  /// @param deviation [cells] of the Gaussian that the field is blurred by, above 0
  SignedField(const grid::OccupancyGrid& map, double deviation);

  /// Bilinear between the centres of cells; 0 outside. @param point [m] in the frame of the map
  [[nodiscard]] double at(const Eigen::Vector2d& point) const;

 private:
  grid::GridGeometry geometry_;
  cv::Mat values_;  ///< float, row 0 is the grid's row 0
};

}  // namespace omega_slam::evaluation

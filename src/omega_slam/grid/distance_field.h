#pragma once

#include <cstdint>
#include <vector>

#include "omega_slam/grid/grid_geometry.h"

namespace omega_slam::grid {

/// What lies beyond the edge of a grid.
enum class Outside : std::uint8_t { kOpen, kObstacle };

/// How far it is to the nearest obstacle, anywhere on a grid. An obstacle is the whole square of
/// its cell: distances are to its nearest point, so that a disc is clear of the squares if and only
/// if its centre is at least its radius away from all.
///
/// Made in time linear in the cells, by two passes of lower envelopes of parabolas (Felzenszwalb
/// and Huttenlocher, "Distance Transforms of Sampled Functions", Theory of Computing 8, 2012,
/// section 2). Deviation: the paper measures to the obstacles' sample points; here parabolas also
/// stand on the left and right edges of the squares, and the first pass counts from their lower and
/// upper edges. Immutable, so any number of threads may ask it.
class DistanceField {
 public:
  DistanceField() = default;  ///< no cells: all is outside, and free

  /// @param obstacles row-major, one byte a cell, not 0: an obstacle
  /// @throws std::invalid_argument if the obstacles are not one a cell
  DistanceField(const GridGeometry& geometry, std::vector<std::uint8_t> obstacles, Outside outside);

  [[nodiscard]] const GridGeometry& geometry() const { return geometry_; }
  [[nodiscard]] bool isObstacle(const Cell& cell) const {
    return geometry_.contains(cell) ? obstacles_[geometry_.index(cell)] != 0
                                    : outside_ == Outside::kObstacle;
  }

  /// From the centre of a cell of the grid [m]; infinite where there is no obstacle at all.
  [[nodiscard]] float atCell(const Cell& cell) const { return distances_[geometry_.index(cell)]; }

  /// From a point, at least so far [m]; in the grid, at most a cell's diagonal more. Outside of the
  /// grid 0 where that is an obstacle; where it is open, never less than to the grid's edge.
  [[nodiscard]] double lowerBound(const Eigen::Vector2d& point) const;

  /// From a point, by interpolation between the centres of the cells around it: within a few
  /// millimetres where obstacles are smooth. Outside of the grid, lowerBound().
  [[nodiscard]] double interpolated(const Eigen::Vector2d& point) const;

  /// Whether a disc about the point is clear of all obstacles. Exact; it looks at single squares
  /// only where the field of distances leaves it open.
  /// @param point [m], finite; @param radius [m]
  [[nodiscard]] bool isClear(const Eigen::Vector2d& point, double radius) const;

 private:
  /// lowerBound() of a point in a cell or on its edge.
  [[nodiscard]] double boundFrom(const Cell& cell, const Eigen::Vector2d& point) const;
  [[nodiscard]] bool isClearOfSquares(const Eigen::Vector2d& point, double radius) const;

  GridGeometry geometry_;
  std::vector<std::uint8_t> obstacles_;
  std::vector<float> distances_;
  Outside outside_{Outside::kOpen};
};

}  // namespace omega_slam::grid

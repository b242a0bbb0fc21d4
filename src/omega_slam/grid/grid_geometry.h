#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>

namespace omega_slam::grid {

/// A cell by column (x) and row (y). Cell (0, 0) is the one whose lower left corner is the grid's
/// origin.
using Cell = Eigen::Vector2i;

/// Where a grid of square cells lies in its frame. Axes are parallel to the frame's; rows grow with
/// y, columns with x, as in nav_msgs/OccupancyGrid. Cell c covers [origin + c * resolution, origin
/// + (c + 1) * resolution).
struct GridGeometry {
  double resolution{0.05};           ///< [m] edge of a cell
  Eigen::Vector2d origin{0.0, 0.0};  ///< [m] lower left corner of cell (0, 0)
  int width{0};                      ///< columns
  int height{0};                     ///< rows

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] bool contains(const Cell& cell) const {
    return cell.x() >= 0 && cell.y() >= 0 && cell.x() < width && cell.y() < height;
  }
  /// Row-major index; the cell must be inside.
  [[nodiscard]] std::size_t index(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(cell.x());
  }
  /// The cell that a point [m] falls into; it may lie outside of the grid. The point must be within
  /// about 2^31 cells of the origin.
  [[nodiscard]] Cell cellAt(const Eigen::Vector2d& point) const {
    return {static_cast<int>(std::floor((point.x() - origin.x()) / resolution)),
            static_cast<int>(std::floor((point.y() - origin.y()) / resolution))};
  }
  /// Centre of a cell [m].
  [[nodiscard]] Eigen::Vector2d center(const Cell& cell) const {
    return origin + resolution * (cell.cast<double>() + Eigen::Vector2d(0.5, 0.5));
  }
};

}  // namespace omega_slam::grid

#pragma once

#include <vector>

#include "omega_slam/grid/grid_geometry.h"

namespace omega_slam::mapping {

/// Rays from one point, in the order of their angles. Near that point most of their cells are cells
/// of other rays too; the fan says how far each ray may be left out because two others pass all of
/// its cells.
///
/// Take a ray and two others, one on each side of it, all with the same longer axis, say y. In a
/// row that all three cross, as long as the other two are less than a cell apart at both borders of
/// the row, the cells of the one adjoin those of the other, and those of the ray between them are
/// among both. So ray k, an odd multiple of 2^t, is left out up to where rays k - 2^t and k + 2^t
/// are a cell apart, or one of them ends. Of those, the cells are drawn, or left out for the same
/// reason; so in the end no cell is missing, and of the many rays near the point only few are
/// drawn.
class RayFan {
 public:
  /// @param start, ends [cells]
  RayFan(const Eigen::Vector2d& start, const std::vector<Eigen::Vector2d>& ends);

  /// How many borders that cross its longer axis a ray passes in cells that others pass as well;
  /// more than it has: it can be left out as a whole. For grid::traverseRows().
  [[nodiscard]] int coveredBorders(std::size_t ray) const;

 private:
  struct Ray {
    int direction{0};       ///< of the longer axis: 1 for x, 2 for y, and its sign
    double reach{0.0};      ///< [cells] along it
    double slope{0.0};      ///< of the other axis by this one
    double to_border{0.0};  ///< [cells] along it from the start to the first border
  };
  std::vector<Ray> rays_;
};

}  // namespace omega_slam::mapping

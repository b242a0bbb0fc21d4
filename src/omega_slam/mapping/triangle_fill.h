#pragma once

#include <array>

#include "omega_slam/mapping/sweep_cells.h"

namespace omega_slam::mapping {

/// Corners [cells], in any order and turning either way.
using Triangle = std::array<Eigen::Vector2d, 3>;

/// Marks as free the cells whose centres lie in a triangle, its border included; none if the
/// corners lie on a line. Row by row: the two sides that a row meets say where its cells begin and
/// end, and words of cells are marked at once. The same cells as fillTriangleByCellTest, at a
/// fraction of the cost.
void fillTriangle(const Triangle& triangle, SweepCells& cells);

/// The same by the paper's method (section 6.2): every cell of the bounding box is tested by
/// itself, with two cross products for each side, of the cell and of the opposite corner, and a dot
/// product that says whether both lie on the same side of it. What tests and benchmarks compare
/// with.
void fillTriangleByCellTest(const Triangle& triangle, SweepCells& cells);

}  // namespace omega_slam::mapping

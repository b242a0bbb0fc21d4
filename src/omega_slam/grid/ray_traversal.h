#pragma once

#include <cmath>
#include <cstdlib>

#include "omega_slam/grid/grid_geometry.h"

namespace omega_slam::grid {

namespace detail {

/// One axis of a walk along a segment, in units of cells.
struct RayAxis {
  double start{0.0};
  double length{0.0};  ///< absolute
  int cell{0};
  int step{0};         ///< +1 or -1
  int steps_left{0};   ///< borders still to be crossed
  double border{0.0};  ///< the next one

  RayAxis(double from, double to)
      : start(from),
        length(std::abs(to - from)),
        cell(static_cast<int>(std::floor(from))),
        step(to < from ? -1 : 1),
        steps_left(std::abs(static_cast<int>(std::floor(to)) - cell)),
        border(step > 0 ? cell + 1.0 : cell) {}

  /// Way from the start to the next border.
  [[nodiscard]] double toBorder() const { return std::abs(border - start); }
  void advance() {
    cell += step;
    border += step;
    --steps_left;
  }
};

}  // namespace detail

/// Visits the cells of a segment in order, from the cell of `start` to the cell of `end`, both
/// included (Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987).
///
/// Exactly those cells are visited that hold a point of the segment, where a cell owns its lower
/// and left border and not the others (see GridGeometry). A segment through the very corner of four
/// cells therefore goes straight from one to the one opposite where both coordinates grow or both
/// shrink, and by way of the upper right one of the four otherwise.
///
/// Deviations from the paper: the number of steps is known from the end cells, so that rounding can
/// never lead past the end; and the crossings are compared by cross-multiplication from the
/// start, so that no error accumulates along the ray.
///
/// @param start, end [cells], that is (p - origin) / resolution; finite and within about 2^30
/// @param visit called as visit(Cell) for each; cells may lie outside of any grid
template <typename Visitor>
void traverseCells(const Eigen::Vector2d& start, const Eigen::Vector2d& end, Visitor&& visit) {
  detail::RayAxis x(start.x(), end.x());
  detail::RayAxis y(start.y(), end.y());
  visit(Cell(x.cell, y.cell));
  while (x.steps_left > 0 || y.steps_left > 0) {
    // Of two crossings, the one after the smaller share of the segment comes first:
    // toBorder / length, without a division that might be by zero.
    const double x_share = x.toBorder() * y.length;
    const double y_share = y.toBorder() * x.length;
    bool cross_x = y.steps_left == 0 || (x.steps_left > 0 && x_share <= y_share);
    bool cross_y = x.steps_left == 0 || (y.steps_left > 0 && y_share <= x_share);
    if (cross_x && cross_y && x.step != y.step) {
      // Upwards a border belongs to the cell beyond it, downwards to the cell before it.
      cross_x = x.step > 0;
      cross_y = !cross_x;
    }
    if (cross_x) {
      x.advance();
    }
    if (cross_y) {
      y.advance();
    }
    visit(Cell(x.cell, y.cell));
  }
}

/// As above with points [m] in the frame of `geometry`.
template <typename Visitor>
void traverseRay(const GridGeometry& geometry, const Eigen::Vector2d& start,
                 const Eigen::Vector2d& end, Visitor&& visit) {
  traverseCells((start - geometry.origin) / geometry.resolution,
                (end - geometry.origin) / geometry.resolution, visit);
}

}  // namespace omega_slam::grid

#pragma once

#include <algorithm>
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
  void advance(int cells = 1) {
    cell += cells * step;
    border += cells * step;
    steps_left -= cells;
  }
};

/// Crosses the border, or the two at a corner, that a segment meets next.
inline void advanceToNextCell(RayAxis& x, RayAxis& y) {
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
}

/// Goes on into the next row. @return the column of the last cell of the row that is left
inline int advanceToNextRow(RayAxis& x, RayAxis& y, double x_per_y) {
  constexpr double kDoubt = 1e-6;  // [cells] so near to a corner, rounding may decide wrongly
  // Whole: borders of columns that are crossed before that of the row. Where the way up is next to
  // nothing, x_per_y is infinite, and this may be so too, or no number.
  const double most = x.steps_left + 1.0;
  const double ratio = y.toBorder() * x_per_y - x.toBorder() + 1.0;
  const double passed = ratio < most ? ratio : most;
  const int whole = static_cast<int>(passed);
  const double part = passed - whole;
  if (part > kDoubt && part < 1.0 - kDoubt) {
    x.advance(std::min(whole, x.steps_left));
    y.advance();
    return x.cell;
  }
  const int row = y.cell;
  int last = x.cell;
  while (y.cell == row) {
    last = x.cell;
    advanceToNextCell(x, y);
  }
  return last;
}

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
    detail::advanceToNextCell(x, y);
    visit(Cell(x.cell, y.cell));
  }
}

/// The same cells row by row: for who can take those of a row at once, several times as fast.
///
/// @param skipped so many borders that cross the longer axis of the segment are passed by before
/// the first visit: of the cells before them none is visited; all may be left out
/// @param visit called as visit(row, first, last) for each row in order, with the columns of its
/// cells, both included, first <= last
template <typename Visitor>
void traverseRows(const Eigen::Vector2d& start, const Eigen::Vector2d& end, int skipped,
                  Visitor&& visit) {
  detail::RayAxis x(start.x(), end.x());
  detail::RayAxis y(start.y(), end.y());
  if (skipped > 0) {
    detail::RayAxis& longer = x.length > y.length ? x : y;
    detail::RayAxis& shorter = x.length > y.length ? y : x;
    if (skipped > longer.steps_left) {
      return;
    }
    longer.advance(skipped - 1);
    detail::advanceToNextRow(shorter, longer, shorter.length / longer.length);
  }
  const double x_per_y = y.steps_left > 0 ? x.length / y.length : 0.0;
  while (y.steps_left > 0) {
    const int row = y.cell;
    const int first = x.cell;
    const int last = detail::advanceToNextRow(x, y, x_per_y);
    visit(row, std::min(first, last), std::max(first, last));
  }
  const int last = x.cell + x.step * x.steps_left;
  visit(y.cell, std::min(x.cell, last), std::max(x.cell, last));
}

/// As above with points [m] in the frame of `geometry`.
template <typename Visitor>
void traverseRay(const GridGeometry& geometry, const Eigen::Vector2d& start,
                 const Eigen::Vector2d& end, Visitor&& visit) {
  traverseCells((start - geometry.origin) / geometry.resolution,
                (end - geometry.origin) / geometry.resolution, visit);
}

}  // namespace omega_slam::grid

#include "omega_slam/mapping/triangle_fill.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::mapping {
namespace {

/// Twice the signed area of a, b and p: above 0 if p is left of the way from a to b.
double sideOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

Eigen::Vector2d centerOf(int x, int y) { return {x + 0.5, y + 0.5}; }

/// std::floor for values that fit into an int; without SSE 4.1 that one is a call.
int floorOf(double value) {
  const int cut = static_cast<int>(value);
  return cut - (value < cut ? 1 : 0);
}

/// The first, and the last, cell whose centre lies in [low, high].
int firstCenter(double low) { return -floorOf(0.5 - low); }
int lastCenter(double high) { return floorOf(high - 0.5); }

/// A side of a triangle, from a lower corner to a higher one.
class Side {
 public:
  Side(const Eigen::Vector2d& low, const Eigen::Vector2d& high)
      : low_(low), high_(high), slope_((high.x() - low.x()) / (high.y() - low.y())) {}

  /// The first cell of a row whose centre is on the side or right of it.
  [[nodiscard]] int firstRight(int y) const {
    const double x = crossing(y);
    const int near = floorOf(x + 0.5);
    if (std::abs(x - near) > kDoubt) {
      return near < x ? near + 1 : near;
    }
    return sideOf(low_, high_, centerOf(near, y)) <= 0.0 ? near : near + 1;
  }

  /// The last cell of a row whose centre is on the side or left of it.
  [[nodiscard]] int lastLeft(int y) const {
    const double x = crossing(y);
    const int near = floorOf(x + 0.5);
    if (std::abs(x - near) > kDoubt) {
      return near > x ? near - 1 : near;
    }
    return sideOf(low_, high_, centerOf(near, y)) >= 0.0 ? near : near - 1;
  }

 private:
  /// [cells] So near to a centre, rounding may have carried a crossing past it.
  static constexpr double kDoubt = 1e-6;

  /// Where the side meets a row's centre line, counted so that centres are whole numbers.
  [[nodiscard]] double crossing(int y) const {
    return low_.x() + slope_ * (y + 0.5 - low_.y()) - 0.5;
  }

  Eigen::Vector2d low_;
  Eigen::Vector2d high_;
  double slope_;  ///< meaningless for a level side, which no row is asked of
};

}  // namespace

void fillTriangle(const Triangle& triangle, SweepCells& cells) {
  Triangle corners = triangle;
  std::sort(corners.begin(), corners.end(),
            [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.y() < b.y(); });
  const auto& [low, middle, high] = corners;
  const double turn = sideOf(low, high, middle);
  if (turn == 0.0) {
    return;
  }
  const Side whole(low, high);
  const Side lower(low, middle);
  const Side upper(middle, high);
  const int last = lastCenter(high.y());
  for (int y = firstCenter(low.y()); y <= last; ++y) {
    const bool is_above = y + 0.5 >= middle.y() && middle.y() < high.y();
    const Side& broken = is_above ? upper : lower;
    const Side& left = turn > 0.0 ? broken : whole;
    const Side& right = turn > 0.0 ? whole : broken;
    const int first_x = left.firstRight(y);
    const int last_x = right.lastLeft(y);
    if (first_x <= last_x) {  // of thin triangles, most rows have no centre inside
      cells.markFreeRow(y, first_x, last_x);
    }
  }
}

void fillTriangleByCellTest(const Triangle& triangle, SweepCells& cells) {
  const auto& [a, b, c] = triangle;
  if (sideOf(a, b, c) == 0.0) {
    return;
  }
  const Eigen::Vector2d min = a.cwiseMin(b).cwiseMin(c);
  const Eigen::Vector2d max = a.cwiseMax(b).cwiseMax(c);
  for (int y = firstCenter(min.y()); y <= lastCenter(max.y()); ++y) {
    for (int x = firstCenter(min.x()); x <= lastCenter(max.x()); ++x) {
      const Eigen::Vector2d p = centerOf(x, y);
      if (sideOf(a, b, c) * sideOf(a, b, p) >= 0.0 && sideOf(b, c, a) * sideOf(b, c, p) >= 0.0 &&
          sideOf(c, a, b) * sideOf(c, a, p) >= 0.0) {
        cells.markFree({x, y});
      }
    }
  }
}

}  // namespace omega_slam::mapping

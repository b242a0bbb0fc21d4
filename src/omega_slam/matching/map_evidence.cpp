#include "omega_slam/matching/map_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr int kAround = 4;           // [cells] to each side of a point that its surface is made of
constexpr double kReachCells = 2.0;  // of the grid that is looked at, at most

const ValueGrid& gridFor(const LocalMap& map, double reach) {
  for (const ValueGrid& grid : map.grids()) {
    if (reach <= kReachCells * grid.geometry.resolution * (1.0 + 1e-9)) {
      return grid;
    }
  }
  return map.grids().back();
}

/// The occupied cells around a place, each as heavy as it is likely. Whole numbers count from the
/// cell whose lower left corner is nearest to the place, doubles from the place itself.
struct Neighbourhood {
  Eigen::Vector2d shift{0.0, 0.0};  ///< [cells] from the place to the centre of that cell
  int count{0};
  int weight{0};
  int x{0};
  int y{0};
  int xx{0};
  int xy{0};
  int yy{0};
  Eigen::Vector2d nearest{0.0, 0.0};
  double nearest_squared{std::numeric_limits<double>::infinity()};

  /// @param values of the cells of row y, from column begin to before column end
  void addRow(const std::uint8_t* values, int row, int begin, int end) {
    constexpr std::array<std::uint8_t, 2 * kAround> kFree{};
    if (end - begin == 2 * kAround && std::memcmp(values, kFree.data(), kFree.size()) == 0) {
      return;  // as most are
    }
    int cells = 0;
    int sum = 0;
    int first = 0;
    int second = 0;
    double closest = std::numeric_limits<double>::infinity();
    for (int column = begin; column < end; ++column) {
      const int value = values[column - begin];
      if (value > 0) {
        ++cells;
        sum += value;
        first += value * column;
        second += value * column * column;
        const double gap = column + shift.x();
        closest = std::abs(gap) < std::abs(closest) ? gap : closest;
      }
    }
    if (cells > 0) {
      count += cells;
      weight += sum;
      x += first;
      xx += second;
      y += sum * row;
      xy += first * row;
      yy += sum * row * row;
      lookAt({closest, row + shift.y()});
    }
  }

  void lookAt(const Eigen::Vector2d& cell) {
    if (cell.squaredNorm() < nearest_squared) {
      nearest_squared = cell.squaredNorm();
      nearest = cell;
    }
  }

  [[nodiscard]] Eigen::Vector2d mean() const { return shift + Eigen::Vector2d(x, y) / weight; }

  /// [m^2] as if each cell were one point
  [[nodiscard]] Eigen::Matrix2d scatter(double resolution) const {
    Eigen::Matrix2d squares;
    squares << xx, xy, xy, yy;
    const Eigen::Vector2d sum(x, y);
    return resolution * resolution * count / weight * (squares - sum * sum.transpose() / weight);
  }
};

/// @param place [cells] in the grid; outside of it there is nothing
Neighbourhood lookAround(const ValueGrid& grid, const Eigen::Vector2d& place) {
  if (!(place.x() >= 0.0 && place.y() >= 0.0 && place.x() < grid.geometry.width &&
        place.y() < grid.geometry.height)) {
    return {};
  }
  const grid::Cell middle = place.array().round().cast<int>();
  const grid::Cell low = (-middle).cwiseMax(-kAround);
  const grid::Cell high =
      (grid::Cell(grid.geometry.width, grid.geometry.height) - middle).cwiseMin(kAround);
  Neighbourhood found;
  found.shift = (middle.cast<double>() - place).array() + 0.5;
  for (int row = low.y(); row < high.y(); ++row) {
    const grid::Cell start = middle + grid::Cell(low.x(), row);
    found.addRow(&grid.values[grid.geometry.index(start)], row, low.x(), high.x());
  }
  return found;
}

}  // namespace

MatchEvidence gatherEvidence(const LocalMap& map, const Points& scan, const Pose2& T_map_scan,
                             double reach) {
  const ValueGrid& grid = gridFor(map, reach);
  const double resolution = grid.geometry.resolution;
  const Eigen::Matrix2d rotation = T_map_scan.rotation();
  const double farthest = std::pow(reach / resolution, 2);
  MatchEvidence evidence;
  evidence.points = scan.size();
  for (const Eigen::Vector2d& p_scan : scan) {
    const Eigen::Vector2d arm = rotation * p_scan;
    const Eigen::Vector2d p_grid = arm + T_map_scan.translation() - grid.geometry.origin;
    const Neighbourhood cells = lookAround(grid, p_grid / resolution);
    if (cells.nearest_squared > farthest) {
      continue;
    }
    const Surface surface = fitSurface(cells.scatter(resolution), cells.count);
    const Eigen::Vector2d partner = surface.isLine() ? cells.mean() : cells.nearest;
    evidence.add(surface, -partner * resolution, arm);
  }
  return evidence;
}

MatchResult judgeOnMap(const LocalMap& map, const Points& scan, const Pose2& T_map_scan,
                       const MatchConfig& config) {
  return judgeEvidence(gatherEvidence(map, scan, T_map_scan, config.outlier_distance), T_map_scan,
                       config);
}

double contradictionOf(const LocalMap& map, const Points& scan, const Pose2& T_map_scan) {
  if (scan.empty()) {
    return 0.0;
  }
  const auto contradicted = std::count_if(
      scan.begin(), scan.end(),
      [&](const Eigen::Vector2d& p_scan) { return map.isFreeAround(T_map_scan * p_scan); });
  return static_cast<double>(contradicted) / static_cast<double>(scan.size());
}

}  // namespace omega_slam::matching

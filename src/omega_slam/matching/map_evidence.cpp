#include "omega_slam/matching/map_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
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

  using Row = std::array<std::uint8_t, 2 * kAround>;  ///< from column -kAround on

  void addRow(const Row& values, int row) {
    if (values == Row{}) {
      return;  // as most are
    }
    int sum = 0;
    int first = 0;
    int second = 0;
    for (int column = -kAround; column < kAround; ++column) {
      const int value = values[static_cast<std::size_t>(column + kAround)];
      count += value > 0 ? 1 : 0;
      sum += value;
      first += value * column;
      second += value * column * column;
    }
    weight += sum;
    x += first;
    xx += second;
    y += sum * row;
    xy += first * row;
    yy += sum * row * row;
    lookAt({closestIn(values), row + shift.y()});
  }

  /// Along the row, from the place to the nearest occupied cell. The place lies between the centres
  /// of columns -1 and 0.
  [[nodiscard]] double closestIn(const Row& values) const {
    const auto is_occupied = [](std::uint8_t value) { return value > 0; };
    const auto middle = values.begin() + kAround;
    const auto right = std::find_if(middle, values.end(), is_occupied);
    const auto left = std::find_if(std::make_reverse_iterator(middle), values.rend(), is_occupied);
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const double to_right =
        right == values.end() ? kNone : static_cast<double>(right - middle) + shift.x();
    const double to_left =
        left == values.rend() ? -kNone : static_cast<double>(left.base() - 1 - middle) + shift.x();
    return -to_left <= to_right ? to_left : to_right;
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
    const std::uint8_t* const first = &grid.values[grid.geometry.index(start)];
    Neighbourhood::Row values{};
    if (high.x() - low.x() == 2 * kAround) {
      std::copy_n(first, 2 * kAround, values.begin());  // without a loop
    } else {
      std::copy_n(first, high.x() - low.x(), values.begin() + (low.x() + kAround));
    }
    found.addRow(values, row);
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
  const geometry::PointTransform to_map(T_map_scan);
  const auto contradicted = std::count_if(
      scan.begin(), scan.end(),
      [&](const Eigen::Vector2d& p_scan) { return map.isFreeAround(to_map * p_scan); });
  return static_cast<double>(contradicted) / static_cast<double>(scan.size());
}

}  // namespace omega_slam::matching

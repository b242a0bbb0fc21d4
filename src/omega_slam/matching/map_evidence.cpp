#include "omega_slam/matching/map_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

using Rows = std::array<std::uint64_t, 2 * kAround>;  ///< a byte a cell, the first column lowest

/// As one word, the first lowest: a single load.
std::uint64_t packed(const std::uint8_t* values) {
  std::uint64_t word = 0;
  for (std::size_t k = 0; k < 2 * kAround; ++k) {
    word |= static_cast<std::uint64_t>(values[k]) << (8 * k);
  }
  return word;
}

/// The highest bit of each byte that is not zero.
std::uint64_t filledBytes(std::uint64_t word) {
  constexpr std::uint64_t kLowBits = 0x7f7f7f7f7f7f7f7f;
  return (((word & kLowBits) + kLowBits) | word) & ~kLowBits;
}

/// Sums over cells, each as heavy as it is likely, four columns at once: in the quarters of words.
/// Of eight rows none exceeds 16 bits.
struct ColumnSums {
  std::uint64_t weight{0};
  std::uint64_t y{0};
  std::uint64_t yy{0};

  void add(std::uint64_t values, std::uint64_t row) {
    weight += values;
    y += row * values;
    yy += row * row * values;
  }

  /// @param column between 0 and 3
  [[nodiscard]] static int at(std::uint64_t sums, int column) {
    return static_cast<int>((sums >> (16 * column)) & 0xffff);
  }
};

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

  void sumUp(const Rows& rows) {
    constexpr std::uint64_t kEvenBytes = 0x00ff00ff00ff00ff;
    ColumnSums even;
    ColumnSums odd;
    std::uint64_t filled = 0;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      even.add(rows[row] & kEvenBytes, row);
      odd.add((rows[row] >> 8) & kEvenBytes, row);
      filled += filledBytes(rows[row]) >> 7;
    }
    count = static_cast<int>((filled * 0x0101010101010101) >> 56);
    for (int k = 0; k < kAround; ++k) {
      addColumn(2 * k, k, even);
      addColumn(2 * k + 1, k, odd);
    }
    // So far from the corner.
    constexpr int kSquare = kAround * kAround;
    xx += kSquare * weight - 2 * kAround * x;
    yy += kSquare * weight - 2 * kAround * y;
    xy += kSquare * weight - kAround * (x + y);
    x -= kAround * weight;
    y -= kAround * weight;
  }

  void addColumn(int column, int quarter, const ColumnSums& sums) {
    const int sum = ColumnSums::at(sums.weight, quarter);
    const int by_row = ColumnSums::at(sums.y, quarter);
    weight += sum;
    x += column * sum;
    xx += column * column * sum;
    y += by_row;
    xy += column * by_row;
    yy += ColumnSums::at(sums.yy, quarter);
  }

  /// From the middle on: what is found there spares a look at most others. Of two as near the lower
  /// one.
  void findNearest(const Rows& rows) {
    for (int way = 0; way < kAround; ++way) {
      lookAt(rows, way);
      lookAt(rows, -1 - way);
    }
  }

  void lookAt(const Rows& rows, int row) {
    const double up = row + shift.y();
    const std::uint64_t filled = filledBytes(rows[static_cast<std::size_t>(row + kAround)]);
    if (filled == 0 || up * up > nearest_squared) {
      return;
    }
    const Eigen::Vector2d cell(closestIn(filled), up);
    const double squared = cell.squaredNorm();
    if (squared < nearest_squared || (row < 0 && squared == nearest_squared)) {
      nearest_squared = squared;
      nearest = cell;
    }
  }

  /// Along a row, from the place to the nearest occupied cell. The place lies between the centres
  /// of columns -1 and 0.
  /// @param filled the highest bits of the occupied cells' bytes, of one at least
  [[nodiscard]] double closestIn(std::uint64_t filled) const {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const std::uint64_t right = filled >> 32;
    const std::uint64_t left = filled << 32;
    const double to_right = right == 0 ? kNone : __builtin_ctzll(right) / 8 + shift.x();
    const double to_left = left == 0 ? -kNone : -1 - __builtin_clzll(left) / 8 + shift.x();
    return -to_left <= to_right ? to_left : to_right;
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

/// The cells from `start` on; zero outside of the grid.
Rows rowsFrom(const ValueGrid& grid, const grid::Cell& start) {
  constexpr int kSide = 2 * kAround;
  const grid::Cell end(grid.geometry.width, grid.geometry.height);
  Rows rows{};
  if ((start.array() >= 0).all() && ((start.array() + kSide) <= end.array()).all()) {
    const std::uint8_t* first = &grid.values[grid.geometry.index(start)];
    for (std::uint64_t& row : rows) {
      row = packed(first);
      first += grid.geometry.width;
    }
    return rows;
  }
  const grid::Cell low = (-start).cwiseMax(0);
  const grid::Cell high = (end - start).cwiseMin(kSide);
  for (int row = low.y(); row < high.y(); ++row) {
    std::array<std::uint8_t, kSide> values{};
    const std::uint8_t* const first =
        &grid.values[grid.geometry.index(start + grid::Cell(low.x(), row))];
    std::copy_n(first, high.x() - low.x(), values.begin() + low.x());
    rows[static_cast<std::size_t>(row)] = packed(values.data());
  }
  return rows;
}

/// @param place [cells] in the grid; outside of it there is nothing
Neighbourhood lookAround(const ValueGrid& grid, const Eigen::Vector2d& place) {
  if (!(place.x() >= 0.0 && place.y() >= 0.0 && place.x() < grid.geometry.width &&
        place.y() < grid.geometry.height)) {
    return {};
  }
  const grid::Cell middle = (place.array() + 0.5).cast<int>();
  const Rows rows = rowsFrom(grid, middle.array() - kAround);
  Neighbourhood found;
  found.shift = (middle.cast<double>() - place).array() + 0.5;
  found.sumUp(rows);
  if (found.count > 0) {
    found.findNearest(rows);
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

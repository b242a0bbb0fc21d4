#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "omega_slam/grid/ray_traversal.h"
#include "support/seeds.h"

namespace omega_slam::grid {
namespace {

using CellSet = std::set<std::pair<int, int>>;

/// Points are whole numbers of sixteenths of a cell here, so that the oracle is exact.
constexpr int kParts = 16;
struct Point {
  std::int64_t x;
  std::int64_t y;
};

Eigen::Vector2d inCells(const Point& p) {
  return {static_cast<double>(p.x) / kParts, static_cast<double>(p.y) / kParts};
}

/// A share num / den of the segment, den > 0; `after`: just past it.
struct Share {
  std::int64_t num;
  std::int64_t den;
  bool after;
};

bool less(const Share& a, const Share& b) {
  const std::int64_t left = a.num * b.den;
  const std::int64_t right = b.num * a.den;
  return left != right ? left < right : (!a.after && b.after);
}

/// The shares at which from + share * (to - from) lies in [low, high): [first, last).
bool clip(std::int64_t from, std::int64_t to, std::int64_t low, Share& first, Share& last) {
  const std::int64_t high = low + kParts;
  const std::int64_t d = to - from;
  if (d == 0) {
    return low <= from && from < high;
  }
  const Share enter = d > 0 ? Share{low - from, d, false} : Share{from - high, -d, true};
  const Share leave = d > 0 ? Share{high - from, d, false} : Share{from - low, -d, true};
  first = less(first, enter) ? enter : first;
  last = less(leave, last) ? leave : last;
  return true;
}

/// Brute force: does the half-open cell hold a point of the closed segment? In whole numbers.
bool holds(int cell_x, int cell_y, const Point& a, const Point& b) {
  Share first{0, 1, false};
  Share last{1, 1, true};  // the end itself belongs to the segment
  return clip(a.x, b.x, std::int64_t{cell_x} * kParts, first, last) &&
         clip(a.y, b.y, std::int64_t{cell_y} * kParts, first, last) && less(first, last);
}

CellSet bruteForce(const Point& a, const Point& b) {
  const auto floored = [](std::int64_t v) {
    return static_cast<int>(v >= 0 ? v / kParts : -((-v + kParts - 1) / kParts));
  };
  CellSet cells;
  for (int x = floored(std::min(a.x, b.x)) - 1; x <= floored(std::max(a.x, b.x)) + 1; ++x) {
    for (int y = floored(std::min(a.y, b.y)) - 1; y <= floored(std::max(a.y, b.y)) + 1; ++y) {
      if (holds(x, y, a, b)) {
        cells.emplace(x, y);
      }
    }
  }
  return cells;
}

using Walk = std::vector<std::pair<int, int>>;

/// The cells of traverseRows, sorted.
Walk walkByRows(const Eigen::Vector2d& a, const Eigen::Vector2d& b, int skipped = 0) {
  Walk cells;
  traverseRows(a, b, skipped, [&cells](int row, int first, int last) {
    EXPECT_LE(first, last);
    for (int x = first; x <= last; ++x) {
      cells.emplace_back(x, row);
    }
  });
  std::sort(cells.begin(), cells.end());
  return cells;
}

/// The cells of traverseCells, sorted, from the one behind so many borders of the longer axis on.
Walk walkByCells(const Eigen::Vector2d& a, const Eigen::Vector2d& b, int skipped = 0) {
  const Eigen::Vector2d way = (b - a).cwiseAbs();
  const int axis = way.x() > way.y() ? 0 : 1;
  const auto first = static_cast<int>(std::floor(a[axis]));
  Walk cells;
  traverseCells(a, b, [&](const Cell& cell) {
    if (std::abs(cell[axis] - first) >= skipped) {
      cells.emplace_back(cell.x(), cell.y());
    }
  });
  std::sort(cells.begin(), cells.end());
  return cells;
}

void expectExact(const Point& a, const Point& b) {
  std::vector<std::pair<int, int>> visited;
  traverseCells(inCells(a), inCells(b),
                [&visited](const Cell& c) { visited.emplace_back(c.x(), c.y()); });
  const CellSet unique(visited.begin(), visited.end());
  ASSERT_EQ(unique.size(), visited.size()) << "a cell was visited twice";
  ASSERT_EQ(walkByRows(inCells(a), inCells(b)), walkByCells(inCells(a), inCells(b)));
  ASSERT_EQ(unique, bruteForce(a, b))
      << "from " << inCells(a).transpose() << " to " << inCells(b).transpose();
}

TEST(RayTraversalProperty, VisitsExactlyTheCellsOfTheSegment) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<std::int64_t> coordinate(-6 * kParts, 6 * kParts);
    for (int trial = 0; trial < 3000; ++trial) {
      const Point a{coordinate(random), coordinate(random)};
      const Point b{coordinate(random), coordinate(random)};
      ASSERT_NO_FATAL_FAILURE(expectExact(a, b));
    }
  }
}

TEST(RayTraversalProperty, ExactWhereBordersAndCornersAreMet) {
  // Halves of cells only: most segments meet borders and corners.
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<std::int64_t> halves(-8, 8);
    const auto coordinate = [&] { return halves(random) * kParts / 2; };
    for (int trial = 0; trial < 3000; ++trial) {
      const Point a{coordinate(), coordinate()};
      const Point b{coordinate(), coordinate()};
      ASSERT_NO_FATAL_FAILURE(expectExact(a, b));
    }
  }
}

TEST(RayTraversalProperty, ExactFarFromTheOrigin) {
  // 2^27 cells of 5 cm are 6700 km.
  constexpr std::int64_t kFar = std::int64_t{kParts} << 27;
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<std::int64_t> coordinate(-6 * kParts, 6 * kParts);
    for (int trial = 0; trial < 1000; ++trial) {
      const Point a{kFar + coordinate(random), coordinate(random) - kFar};
      const Point b{kFar + coordinate(random), coordinate(random) - kFar};
      ASSERT_NO_FATAL_FAILURE(expectExact(a, b));
    }
  }
}

TEST(RayTraversalProperty, RowsHaveTheCellsThatAreNotSkipped) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> coordinate(-100.0, 100.0);
    std::uniform_int_distribution<int> skipped(0, 150);
    for (int trial = 0; trial < 3000; ++trial) {
      Eigen::Vector2d a(coordinate(random), coordinate(random));
      Eigen::Vector2d b(coordinate(random), coordinate(random));
      if (trial % 3 == 0) {  // so that corners are met
        a = a.array().floor();
        b = b.array().floor();
      }
      const int count = skipped(random);
      ASSERT_EQ(walkByRows(a, b, count), walkByCells(a, b, count))
          << "from " << a.transpose() << " to " << b.transpose() << ", skipped: " << count;
    }
  }
}

TEST(RayTraversalProperty, RowsThatAreHardlyEnteredAreWalkedToo) {
  constexpr double kTiny[] = {0.0, 1e-310, 1e-300, 1e-17, 1e-7};
  for (const double below : kTiny) {
    for (const double above : kTiny) {
      for (const double x : {-40.0, 0.0, 40.0}) {
        const Eigen::Vector2d a(0.0, -below);
        const Eigen::Vector2d b(x, above);
        EXPECT_EQ(walkByRows(a, b), walkByCells(a, b)) << below << ' ' << above << ' ' << x;
        EXPECT_EQ(walkByRows(b, a), walkByCells(b, a)) << below << ' ' << above << ' ' << x;
        EXPECT_EQ(walkByRows(a, b, 7), walkByCells(a, b, 7)) << below << ' ' << above << ' ' << x;
      }
    }
  }
}

TEST(RayTraversalProperty, AnyRealSegmentIsAConnectedWalkBetweenItsEndCells) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> coordinate(-100.0, 100.0);
    for (int trial = 0; trial < 2000; ++trial) {
      const Eigen::Vector2d a(coordinate(random), coordinate(random));
      const Eigen::Vector2d b(coordinate(random), coordinate(random));
      std::vector<Cell> cells;
      traverseCells(a, b, [&cells](const Cell& c) { cells.push_back(c); });
      ASSERT_EQ(cells.front(), Cell(a.array().floor().cast<int>()));
      ASSERT_EQ(cells.back(), Cell(b.array().floor().cast<int>()));
      for (std::size_t k = 1; k < cells.size(); ++k) {
        const Cell step = cells[k] - cells[k - 1];
        ASSERT_LE(step.cwiseAbs().maxCoeff(), 1);
        ASSERT_GE(step.cwiseAbs().sum(), 1);
      }
    }
  }
}

}  // namespace
}  // namespace omega_slam::grid

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/ray_traversal.h"
#include "omega_slam/mapping/ray_fan.h"
#include "support/seeds.h"

namespace omega_slam::mapping {
namespace {

using CellSet = std::set<std::pair<int, int>>;
using Points = std::vector<Eigen::Vector2d>;

/// The oracle: every ray by itself, cell by cell.
CellSet cellsOfAll(const Eigen::Vector2d& start, const Points& ends) {
  CellSet cells;
  for (const Eigen::Vector2d& end : ends) {
    grid::traverseCells(start, end, [&cells](const grid::Cell& c) { cells.emplace(c.x(), c.y()); });
  }
  return cells;
}

/// @param drawn counts the rows that were visited
CellSet cellsOfFan(const Eigen::Vector2d& start, const Points& ends, std::size_t& drawn) {
  const RayFan fan(start, ends);
  CellSet cells;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    grid::traverseRows(start, ends[k], fan.coveredBorders(k), [&](int row, int first, int last) {
      ++drawn;
      for (int x = first; x <= last; ++x) {
        cells.emplace(x, row);
      }
    });
  }
  return cells;
}

/// A fan of a laser among walls that begin and end: lengths change little, or jump.
Points laserFan(const Eigen::Vector2d& start, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double increment = 0.001 + 0.03 * share(random) * share(random);
  const double first = 2.0 * geometry::kPi * share(random);
  const double turn = share(random) < 0.5 ? -1.0 : 1.0;
  double length = 100.0 * share(random);
  Points ends;
  for (double angle = 0.0; angle < 6.0; angle += increment * (share(random) < 0.02 ? 5.0 : 1.0)) {
    length = share(random) < 0.05 ? 100.0 * share(random) : std::abs(length + share(random) - 0.5);
    const double heading = first + turn * angle;
    ends.emplace_back(start + length * Eigen::Vector2d(std::cos(heading), std::sin(heading)));
  }
  return ends;
}

/// On quarters of cells, so that borders and corners are met; sorted by angle, some twice.
Points latticeFan(const Eigen::Vector2d& start, std::mt19937_64& random) {
  std::uniform_int_distribution<int> quarter(-80, 80);
  Points ways;
  for (int k = 0; k < 300; ++k) {
    ways.emplace_back(quarter(random) / 4.0, quarter(random) / 4.0);
    if (k % 10 == 0) {
      ways.push_back(ways.back());
    }
  }
  std::sort(ways.begin(), ways.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::atan2(a.y(), a.x()) < std::atan2(b.y(), b.x());
  });
  for (Eigen::Vector2d& way : ways) {
    way += start;
  }
  return ways;
}

TEST(RayFanProperty, NoCellIsMissing) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> coordinate(-50.0, 50.0);
    for (int trial = 0; trial < 20; ++trial) {
      const Eigen::Vector2d start(coordinate(random), coordinate(random));
      const Points ends = laserFan(start, random);
      std::size_t drawn = 0;
      ASSERT_EQ(cellsOfFan(start, ends, drawn), cellsOfAll(start, ends)) << "fan " << trial;
    }
  }
}

TEST(RayFanProperty, NoCellIsMissingWhereBordersAndCornersAreMet) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> quarter(-20, 20);
    for (int trial = 0; trial < 30; ++trial) {
      const Eigen::Vector2d start(quarter(random) / 4.0, quarter(random) / 4.0);
      const Points ends = latticeFan(start, random);
      std::size_t drawn = 0;
      ASSERT_EQ(cellsOfFan(start, ends, drawn), cellsOfAll(start, ends)) << "fan " << trial;
    }
  }
}

TEST(RayFanProperty, OrderIsNoPrecondition) {
  std::mt19937_64 random(1);
  const Eigen::Vector2d start(0.3, -0.7);
  Points ends = laserFan(start, random);
  std::shuffle(ends.begin(), ends.end(), random);
  ends.push_back(start);  // without length
  std::size_t drawn = 0;
  EXPECT_EQ(cellsOfFan(start, ends, drawn), cellsOfAll(start, ends));
}

TEST(RayFanProperty, InACircleMostRowsAreLeftOut) {
  Points ends;
  for (int k = 0; k < 683; ++k) {
    ends.push_back(80.0 * Eigen::Vector2d(std::cos(0.00614 * k), std::sin(0.00614 * k)));
  }
  std::size_t drawn = 0;
  std::size_t whole = 0;
  EXPECT_EQ(cellsOfFan({0.0, 0.0}, ends, drawn), cellsOfAll({0.0, 0.0}, ends));
  for (const Eigen::Vector2d& end : ends) {
    grid::traverseRows({0.0, 0.0}, end, 0, [&whole](int, int, int) { ++whole; });
  }
  EXPECT_LT(2 * drawn, whole);
}

}  // namespace
}  // namespace omega_slam::mapping

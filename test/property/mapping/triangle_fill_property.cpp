#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/mapping/triangle_fill.h"
#include "support/seeds.h"

namespace omega_slam::mapping {
namespace {

using CellSet = std::set<std::pair<int, int>>;

CellSet freeCells(const SweepCells& cells) {
  CellSet result;
  for (const SweepTile& tile : cells.tiles()) {
    for (int y = 0; y < kTileSide; ++y) {
      for (int x = 0; x < kTileSide; ++x) {
        if ((tile.free[static_cast<std::size_t>(y)] >> static_cast<unsigned>(x) & 1U) != 0) {
          result.emplace(cornerOf(tile.index).x() + x, cornerOf(tile.index).y() + y);
        }
      }
    }
  }
  return result;
}

using Fill = void (*)(const Triangle&, SweepCells&);

CellSet filled(Fill fill, const Triangle& triangle) {
  SweepCells cells;
  fill(triangle, cells);
  return freeCells(cells);
}

void expectSame(const Triangle& triangle) {
  ASSERT_EQ(filled(fillTriangle, triangle), filled(fillTriangleByCellTest, triangle))
      << triangle[0].transpose() << ", " << triangle[1].transpose() << ", "
      << triangle[2].transpose();
}

/// Corners on halves and quarters of cells meet many centres exactly, and are exact in the oracle.
Eigen::Vector2d corner(std::mt19937_64& random, int reach) {
  std::uniform_int_distribution<int> quarter(-reach * 4, reach * 4);
  return {quarter(random) / 4.0, quarter(random) / 4.0};
}

TEST(TriangleFillProperty, IsThePapersCellTest) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (const int reach : {1, 4, 20, 150}) {
      for (int k = 0; k < (reach > 100 ? 10 : 150); ++k) {
        expectSame({corner(random, reach), corner(random, reach), corner(random, reach)});
      }
    }
  }
}

TEST(TriangleFillProperty, ThinTrianglesAsOfALaserToo) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> side(-3, 3);
    for (int k = 0; k < 100; ++k) {
      const Eigen::Vector2d start = corner(random, 80);
      const Eigen::Vector2d end = corner(random, 80);
      expectSame({start, end, end + Eigen::Vector2d(side(random) / 4.0, side(random) / 4.0)});
    }
  }
}

TEST(TriangleFillProperty, LevelSidesAndCornersInCentres) {
  const Eigen::Vector2d a(0.5, 0.5);
  for (const Eigen::Vector2d& b : {Eigen::Vector2d(9.5, 0.5), Eigen::Vector2d(0.5, 7.5)}) {
    for (const Eigen::Vector2d& c :
         {Eigen::Vector2d(4.5, 6.5), Eigen::Vector2d(-70.5, -3.5), Eigen::Vector2d(9.5, 7.5)}) {
      expectSame({a, b, c});
      expectSame({c, b, a});
      expectSame({b, a, c});
    }
  }
  EXPECT_EQ(filled(fillTriangle, {a, {2.5, 0.5}, {0.5, 2.5}}).size(), 6U);
}

TEST(TriangleFillProperty, NoneOnALine) {
  EXPECT_TRUE(filled(fillTriangle, {{{0.5, 0.5}, {4.5, 4.5}, {2.5, 2.5}}}).empty());
  EXPECT_TRUE(filled(fillTriangle, {{{0.5, 0.5}, {9.5, 0.5}, {3.5, 0.5}}}).empty());
  EXPECT_TRUE(filled(fillTriangle, {{{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}}}).empty());
}

TEST(TriangleFillProperty, AFanLeavesNoCellOut) {
  // Neighbouring triangles share their sides: together they are the polygon.
  constexpr int kRays = 360;
  constexpr double kReach = 90.0;
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Eigen::Vector2d start = corner(random, 5);
    SweepCells cells;
    const auto end = [&](int k) {
      const double angle = 2.0 * geometry::kPi * k / kRays;
      return Eigen::Vector2d(start + kReach * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    };
    for (int k = 0; k < kRays; ++k) {
      fillTriangle({start, end(k), end(k + 1)}, cells);
    }
    const CellSet marked = freeCells(cells);
    for (int y = -100; y < 100; ++y) {
      for (int x = -100; x < 100; ++x) {
        if ((Eigen::Vector2d(x + 0.5, y + 0.5) - start).norm() < kReach - 0.1) {
          ASSERT_EQ(marked.count({x, y}), 1U) << x << ' ' << y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace omega_slam::mapping

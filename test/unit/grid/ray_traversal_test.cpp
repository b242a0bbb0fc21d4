#include "omega_slam/grid/ray_traversal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace omega_slam::grid {
namespace {

using ::testing::ElementsAre;
using Cells = std::vector<std::pair<int, int>>;

Cells walk(const Eigen::Vector2d& start, const Eigen::Vector2d& end) {
  Cells cells;
  traverseCells(start, end, [&cells](const Cell& c) { cells.emplace_back(c.x(), c.y()); });
  return cells;
}

TEST(RayTraversal, ZeroLengthVisitsOneCell) {
  EXPECT_EQ(walk({0.5, 0.5}, {0.5, 0.5}), (Cells{{0, 0}}));
  EXPECT_EQ(walk({-3.0, 2.0}, {-3.0, 2.0}), (Cells{{-3, 2}}));
}

TEST(RayTraversal, AlongTheAxesInBothSenses) {
  EXPECT_EQ(walk({0.5, 0.5}, {2.5, 0.5}), (Cells{{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_EQ(walk({2.5, 0.5}, {0.5, 0.5}), (Cells{{2, 0}, {1, 0}, {0, 0}}));
  EXPECT_EQ(walk({-0.5, -0.5}, {-0.5, 1.5}), (Cells{{-1, -1}, {-1, 0}, {-1, 1}}));
}

TEST(RayTraversal, AlongABorderStaysInTheCellThatOwnsIt) {
  EXPECT_EQ(walk({0.5, 1.0}, {1.5, 1.0}), (Cells{{0, 1}, {1, 1}}));
}

TEST(RayTraversal, EndOnABorder) {
  EXPECT_EQ(walk({0.5, 0.5}, {1.0, 0.5}), (Cells{{0, 0}, {1, 0}}));
  EXPECT_EQ(walk({1.5, 0.5}, {1.0, 0.5}), (Cells{{1, 0}}));
}

TEST(RayTraversal, StartOnABorder) {
  EXPECT_EQ(walk({1.0, 0.5}, {0.5, 0.5}), (Cells{{1, 0}, {0, 0}}));
  EXPECT_EQ(walk({1.0, 0.5}, {1.5, 0.5}), (Cells{{1, 0}}));
}

TEST(RayTraversal, ThroughACorner) {
  EXPECT_EQ(walk({0.5, 0.5}, {1.5, 1.5}), (Cells{{0, 0}, {1, 1}}));
  EXPECT_EQ(walk({1.5, 1.5}, {0.5, 0.5}), (Cells{{1, 1}, {0, 0}}));
  EXPECT_EQ(walk({0.5, 1.5}, {1.5, 0.5}), (Cells{{0, 1}, {1, 1}, {1, 0}}));
  EXPECT_EQ(walk({1.5, 0.5}, {0.5, 1.5}), (Cells{{1, 0}, {1, 1}, {0, 1}}));
}

TEST(RayTraversal, SteepAndShallow) {
  EXPECT_EQ(walk({0.1, 0.5}, {2.9, 1.5}), (Cells{{0, 0}, {1, 0}, {1, 1}, {2, 1}}));
  EXPECT_EQ(walk({0.5, 0.1}, {1.5, 2.9}), (Cells{{0, 0}, {0, 1}, {1, 1}, {1, 2}}));
}

TEST(RayTraversal, MetresAndOriginOfAGrid) {
  const GridGeometry geometry{0.5, {-1.0, 10.0}, 4, 4};
  Cells cells;
  traverseRay(geometry, {-0.9, 10.1}, {0.1, 10.2},
              [&cells](const Cell& c) { cells.emplace_back(c.x(), c.y()); });
  EXPECT_THAT(cells, ElementsAre(std::make_pair(0, 0), std::make_pair(1, 0), std::make_pair(2, 0)));
}

}  // namespace
}  // namespace omega_slam::grid

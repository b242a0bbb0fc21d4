#include "omega_slam/evaluation/cell_mask.h"

#include <gtest/gtest.h>

#include "support/drawn_map.h"

namespace omega_slam::evaluation {
namespace {

using grid::Cell;

const grid::OccupancyGrid kTwoRooms = test::drawnMap({
    "#######",
    "#..#..#",
    "#.##..#",
    "#######",
});

TEST(CellMask, KnowsNothingOutside) {
  CellMask mask({1.0, {0.0, 0.0}, 2, 2});
  mask.set({5, 5});
  mask.set({1, 1});
  EXPECT_FALSE(mask.at(Cell(5, 5)));
  EXPECT_TRUE(mask.at(Cell(1, 1)));
  EXPECT_TRUE(mask.at(Eigen::Vector2d(1.5, 1.01)));
  EXPECT_FALSE(mask.at(Eigen::Vector2d(2.0, 1.0)));
  EXPECT_FALSE(mask.at(Eigen::Vector2d(1e300, -1e300)));
  EXPECT_TRUE(mask.touches({2, 2}));
  EXPECT_FALSE(mask.touches({3, 2}));
}

TEST(CellMask, ThresholdsAreThoseOfMapSaver) {
  EXPECT_TRUE(isWall(65));
  EXPECT_FALSE(isWall(64));
  EXPECT_TRUE(isOpen(25));
  EXPECT_FALSE(isOpen(26));
  EXPECT_FALSE(isOpen(-1));
}

TEST(CellMask, CornersConnectNothing) {
  const CellMask left = reachableFrom(kTwoRooms, {1.5, 1.5});
  EXPECT_TRUE(left.at(Cell(2, 2)));
  EXPECT_FALSE(left.at(Cell(4, 2)));
  EXPECT_FALSE(reachableFrom(kTwoRooms, {0.5, 0.5}).at(Cell(1, 1)));
}

TEST(CellMask, TheLargestOpenSpaceIsTheRoomOnTheRight) {
  const CellMask largest = largestOpenSpace(kTwoRooms);
  EXPECT_FALSE(largest.at(Cell(1, 1)));
  EXPECT_TRUE(largest.at(Cell(4, 1)));
  EXPECT_TRUE(largest.at(Cell(5, 2)));
}

TEST(CellMask, WallsWidenInSquaresBeyondTheEdge) {
  const grid::OccupancyGrid dot = test::drawnMap({"...", "...", "..#"});
  const CellMask wide = wallsWidened(dot, 1);
  for (const Eigen::Vector2d& near : {Eigen::Vector2d(1.5, 1.5), Eigen::Vector2d(3.5, -0.5)}) {
    EXPECT_TRUE(wide.at(near));
  }
  for (const Eigen::Vector2d& far : {Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(4.5, 0.5)}) {
    EXPECT_FALSE(wide.at(far));
  }
}

}  // namespace
}  // namespace omega_slam::evaluation

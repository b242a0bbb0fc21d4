#include "omega_slam/exploration/approach.h"

#include <gtest/gtest.h>

#include "support/drawn_map.h"

namespace omega_slam::exploration {
namespace {

/// Whether a robot with a radius of 0.2 m could come up to the only frontier of a map with cells of
/// 0.1 m.
bool couldComeUp(const std::vector<std::string>& rows) {
  const grid::OccupancyGrid map = test::drawnMap(rows, 0.1);
  const MapView view(map);
  std::vector<Cell> cells;
  for (int y = 0; y < map.geometry.height; ++y) {
    for (int x = 0; x < map.geometry.width; ++x) {
      if (view.isFrontier({x, y})) {
        cells.emplace_back(x, y);
      }
    }
  }
  const std::vector<Frontier> frontiers = clusterFrontiers(cells, view);
  EXPECT_EQ(frontiers.size(), 1U);
  return canComeUpTo(frontiers.front(), view, 0.2);
}

TEST(CanComeUpTo, NotIfItLiesInAGapThatIsTooNarrow) {
  EXPECT_FALSE(couldComeUp({"####################",  //
                            "#.........##########",  //
                            "#.........##########",  //
                            "#.................??",  //
                            "#.................??",  //
                            "#.................??",  //
                            "#.........##########",  //
                            "#.........##########",  //
                            "####################"}));
}

TEST(CanComeUpTo, IfItLiesInTheMouthOfAGap) {
  EXPECT_TRUE(couldComeUp({"############",  //
                           "#.........##",  //
                           "#.........##",  //
                           "#.........??",  //
                           "#.........??",  //
                           "#.........??",  //
                           "#.........##",  //
                           "#.........##",  //
                           "############"}));
}

TEST(CanComeUpTo, IfTheRobotFitsThrough) {
  EXPECT_TRUE(couldComeUp({"####################",  //
                           "#.........##########",  //
                           "#.................??",  //
                           "#.................??",  //
                           "#.................??",  //
                           "#.................??",  //
                           "#.................??",  //
                           "#.........##########",  //
                           "####################"}));
}

TEST(CanComeUpTo, ADoorThatIsHalfSeenIsNoGap) {
  EXPECT_TRUE(couldComeUp({"####################",  //
                           "#.........##########",  //
                           "#.................??",  //
                           "#.................??",  //
                           "#.................??",  //
                           "#.........??????????",  //
                           "#.........??????????",  //
                           "#.........##########",  //
                           "####################"}));
}

TEST(CanComeUpTo, NotFromTheOtherSideOfAWall) {
  EXPECT_FALSE(couldComeUp({"####################",  //
                            "#.................##",  //
                            "#.................##",  //
                            "#.................##",  //
                            "#.................##",  //
                            "#################.##",  //
                            "##???..............#",  //
                            "####################"}));
}

}  // namespace
}  // namespace omega_slam::exploration

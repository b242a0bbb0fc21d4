#include "omega_slam/grid/pane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/drawn_map.h"

namespace omega_slam::grid {
namespace {

/// A room of 4 by 2 m above a wall 0.2 m thick with a gap of 1.2 m; cells of 0.1 m.
OccupancyGrid roomWithGap() {
  return test::drawnMap({"                                        ",  //
                         "                                        ",  //
                         "                                        ",  //
                         "                                        ",  //
                         "                                        ",  //
                         "                                        ",  //
                         "                                        ",  //
                         "##############            ##############",  //
                         "?#############            #############?",  //
                         "                                        ",  //
                         "                                        ",  //
                         "                                        "},
                        0.1);
}

TEST(Pane, FillsTheGapInWhichItWasTouched) {
  const OccupancyGrid map = roomWithGap();
  for (const double oblique : {-0.4, 0.0, 0.4}) {  // a bumper is wide
    const auto pane = findPane(map, {1.8, 0.42}, {std::sin(oblique), -std::cos(oblique)});
    ASSERT_TRUE(pane) << oblique;
    EXPECT_NEAR(std::min(pane->from.x(), pane->to.x()), 1.4, 0.1) << oblique;
    EXPECT_NEAR(std::max(pane->from.x(), pane->to.x()), 2.6, 0.1) << oblique;
    EXPECT_NEAR(pane->from.y(), 0.4, 0.15) << oblique;
    EXPECT_NEAR(pane->to.y(), 0.4, 0.15) << oblique;
  }
}

TEST(Pane, DoesNotStandBetweenTwoPosts) {
  OccupancyGrid map = roomWithGap();
  for (int row = 3; row < 5; ++row) {
    for (int column = 0; column < 40; ++column) {
      map.at({column, row}) = column == 13 || column == 26 ? kOccupied : kFree;
    }
  }
  EXPECT_FALSE(findPane(map, {1.8, 0.42}, {0.0, -1.0}));
}

/// Two walls beside each other, and nothing known behind their surfaces.
OccupancyGrid corridor(int thickness) {
  OccupancyGrid map = makeGrid({0.05, {0.0, 0.0}, 80, 120}, kUnknown);
  for (int row = 0; row < map.geometry.height; ++row) {
    for (int column = 30 - thickness; column < 50 + thickness; ++column) {
      map.at({column, row}) = column < 30 || column >= 50 ? kOccupied : kFree;
    }
  }
  return map;
}

TEST(Pane, IsNotFoundAcrossACorridor) {
  for (const int thickness : {1, 2, 4, 20}) {
    for (double turn = -0.6; turn <= 0.6; turn += 0.1) {
      const Eigen::Vector2d normal(std::sin(turn), std::cos(turn));
      EXPECT_FALSE(findPane(corridor(thickness), {2.0, 3.0}, normal)) << thickness << " " << turn;
      EXPECT_FALSE(findPane(corridor(thickness), {1.7, 3.0}, normal)) << thickness << " " << turn;
    }
  }
}

TEST(Pane, IsNotFoundInTheOpenNorWhereTheWallsAreTooFarApart) {
  const OccupancyGrid map = roomWithGap();
  EXPECT_FALSE(findPane(map, {1.8, 0.8}, {0.0, -1.0}));
  EXPECT_FALSE(findPane(makeGrid({0.1, {0.0, 0.0}, 40, 20}, kFree), {1.8, 0.8}, {0.0, -1.0}));
}

TEST(Pane, IsNotFoundWhereTheMapShowsWhatWasTouched) {
  OccupancyGrid map = roomWithGap();
  map.at({18, 4}) = kOccupied;  // a table leg in the gap
  EXPECT_FALSE(findPane(map, {1.85, 0.45}, {0.0, -1.0}));
}

TEST(Pane, IsNotFoundFromNonsense) {
  const OccupancyGrid map = roomWithGap();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(findPane(map, {nan, 0.4}, {0.0, -1.0}));
  EXPECT_FALSE(findPane(map, {1.8, 0.4}, {0.0, nan}));
  EXPECT_FALSE(findPane(map, {1.8, 0.4}, {0.0, 0.0}));
  EXPECT_FALSE(findPane(map, {1e300, 0.4}, {0.0, -1.0}));
  EXPECT_FALSE(findPane({}, {1.8, 0.4}, {0.0, -1.0}));
}

}  // namespace
}  // namespace omega_slam::grid

#include "omega_slam/evaluation/resemblance.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "omega_slam/geometry/angle.h"
#include "support/drawn_map.h"

namespace omega_slam::evaluation {
namespace {

using grid::OccupancyGrid;

ResemblanceOptions strict() {
  ResemblanceOptions options;
  options.wall_tolerance = 0;
  return options;
}

// A room with an open field of 4 x 2 and, behind a wall, a chamber that cannot be entered.
const OccupancyGrid kTruth = test::drawnMap({
    "#########",
    "#....#..#",
    "#....#..#",
    "#########",
});
const Eigen::Vector2d kStart(1.5, 1.5);
const MapPlacement kPlacement{{}, kStart};

TEST(Resemblance, AMapResemblesItself) {
  const Resemblance same = compareMaps(test::drawnMap({
                                           "######???",
                                           "#....#???",
                                           "#....#???",
                                           "######???",
                                       }),
                                       kTruth, kPlacement, strict());
  EXPECT_EQ(same.walls_right, 16U);
  EXPECT_EQ(same.walls_wrong, 0U);
  EXPECT_EQ(same.open_right, 8U);
  EXPECT_EQ(same.open_wrong, 0U);
  EXPECT_EQ(same.walls_to_find, 16U);
  EXPECT_EQ(same.walls_found, 16U);
  EXPECT_EQ(same.open_to_find, 8U);
  EXPECT_DOUBLE_EQ(same.score(), 1.0);
  EXPECT_DOUBLE_EQ(same.balanced(), 1.0);
  EXPECT_DOUBLE_EQ(same.wallRecall(), 1.0);
  EXPECT_DOUBLE_EQ(same.openRecall(), 1.0);
  EXPECT_DOUBLE_EQ(same.coverage(), 1.0);
}

TEST(Resemblance, ByHand) {
  // Right: 3 walls and 4 open cells. Wrong: a wall in the open, two open cells in walls, one in the
  // chamber and one outside.
  const Resemblance some = compareMaps(test::drawnMap({
                                           "##.??????.",
                                           "#..#???..?",
                                           "??..??????",
                                           "??????????",
                                       }),
                                       test::drawnMap({
                                           "#########",
                                           "#....#..#",
                                           "#....#..#",
                                           "#########",
                                       }),
                                       kPlacement, strict());
  EXPECT_EQ(some.walls_right, 3U);
  EXPECT_EQ(some.walls_wrong, 1U);
  EXPECT_EQ(some.open_right, 4U);
  EXPECT_EQ(some.open_wrong, 4U);
  EXPECT_DOUBLE_EQ(some.score(), 7.0 / 12.0);
  EXPECT_DOUBLE_EQ(some.balanced(), 0.5 * (3.0 / 4.0 + 4.0 / 8.0));
  EXPECT_DOUBLE_EQ(some.wallRecall(), 3.0 / 16.0);
  EXPECT_DOUBLE_EQ(some.openRecall(), 4.0 / 8.0);
  EXPECT_DOUBLE_EQ(some.coverage(), 5.0 / 8.0);  // the misplaced wall has been seen too
}

TEST(Resemblance, WallsMayLieACellOff) {
  const OccupancyGrid shifted = test::drawnMap({
      "?????????",
      "######???",
      "?????????",
      "?????????",
  });
  EXPECT_EQ(compareMaps(shifted, kTruth, kPlacement, strict()).walls_right, 2U);
  EXPECT_EQ(compareMaps(shifted, kTruth, kPlacement).walls_right, 6U);
  EXPECT_EQ(compareMaps(shifted, kTruth, kPlacement).walls_found, 10U);  // top row and sides
}

TEST(Resemblance, ThePlacementIsThatOfTheBuiltMapInTheTruth) {
  // The built map is the room seen from a frame at its lower right, turned by 90 degrees.
  const OccupancyGrid built = test::drawnMap({
      "####",
      "#..#",
      "#..#",
      "#..#",
      "#..#",
      "####",
  });
  const MapPlacement turned{{6.0, 0.0, geometry::kPi / 2}, kStart};
  const Resemblance result = compareMaps(built, kTruth, turned, strict());
  EXPECT_DOUBLE_EQ(result.score(), 1.0);
  EXPECT_DOUBLE_EQ(result.coverage(), 1.0);
}

TEST(Resemblance, ResolutionsMayDiffer) {
  OccupancyGrid fine = grid::makeGrid({0.5, {1.0, 1.0}, 8, 4}, grid::kFree);
  const Resemblance result = compareMaps(fine, kTruth, kPlacement, strict());
  EXPECT_EQ(result.open_right, 32U);
  EXPECT_EQ(result.open_found, 8U);
}

TEST(Resemblance, AStartThatIsNotInTheOpenReachesNothing) {
  for (const Eigen::Vector2d& start :
       {Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(-50.0, 0.0), Eigen::Vector2d(1e300, 0.0)}) {
    const Resemblance result = compareMaps(kTruth, kTruth, {{}, start}, strict());
    EXPECT_EQ(result.open_right, 0U);
    EXPECT_EQ(result.open_to_find, 0U);
    EXPECT_DOUBLE_EQ(result.coverage(), 0.0);
  }
}

TEST(Resemblance, WithoutAStartTheLargestOpenSpaceCanBeReached) {
  const MapPlacement anywhere;
  EXPECT_EQ(compareMaps(kTruth, kTruth, anywhere).open_to_find, 8U);
  EXPECT_EQ(compareMaps(kTruth, kTruth, anywhere).open_right,
            compareMaps(kTruth, kTruth, kPlacement).open_right);
}

TEST(Resemblance, EachCellHasItsVerdict) {
  const MapComparison some = judgeMaps(test::drawnMap({
                                           "###?#####",
                                           "#.##.#..#",
                                           "#...?#..#",
                                           "#########",
                                       }),
                                       kTruth, kPlacement, strict());
  const auto built = [&](int x, int y) { return some.built[kTruth.geometry.index({x, y})]; };
  const auto truth = [&](int x, int y) { return some.truth[kTruth.geometry.index({x, y})]; };
  EXPECT_EQ(built(0, 0), Verdict::kWallRight);
  EXPECT_EQ(built(2, 2), Verdict::kWallWrong);
  EXPECT_EQ(built(1, 1), Verdict::kOpenRight);
  EXPECT_EQ(built(7, 1), Verdict::kOpenWrong);  // behind a wall
  EXPECT_EQ(built(4, 1), Verdict::kNone);
  EXPECT_EQ(truth(3, 3), Verdict::kWallMissed);
  EXPECT_EQ(truth(2, 2), Verdict::kOpenMissed);
  EXPECT_EQ(truth(4, 1), Verdict::kOpenUnseen);
  EXPECT_EQ(truth(1, 1), Verdict::kOpenRight);
  EXPECT_EQ(truth(1, 0), Verdict::kWallRight);
  EXPECT_EQ(truth(7, 1), Verdict::kNone);
}

TEST(Resemblance, NothingBuiltResemblesNothing) {
  const Resemblance result = compareMaps({}, kTruth, kPlacement);
  EXPECT_DOUBLE_EQ(result.score(), 0.0);
  EXPECT_EQ(result.open_to_find, 8U);
  EXPECT_DOUBLE_EQ(compareMaps(kTruth, {}, kPlacement).score(), 0.0);
}

TEST(Resemblance, FarPlacementsAreOutside) {
  const Resemblance result = compareMaps(kTruth, kTruth, {{1e12, -1e12, 1.0}, kStart}, strict());
  EXPECT_DOUBLE_EQ(result.score(), 0.0);
}

TEST(Resemblance, TheToleranceIsChecked) {
  ResemblanceOptions options;
  options.wall_tolerance = -1;
  EXPECT_THROW(static_cast<void>(compareMaps(kTruth, kTruth, kPlacement, options)),
               std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::evaluation

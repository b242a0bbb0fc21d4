#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "omega_slam/exploration/fast_detector.h"
#include "omega_slam/exploration/survey.h"
#include "omega_slam/exploration/wavefront_detector.h"
#include "support/drawn_map.h"

namespace omega_slam::exploration {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

bool liesOn(const Frontier& frontier, const MapView& map, const Eigen::Vector2d& point) {
  return std::find(frontier.cells.begin(), frontier.cells.end(), map.cellAt(point)) !=
         frontier.cells.end();
}

TEST(Frontiers, AreUnknownCellsRightNextToOpenOnes) {
  const auto map = test::drawnMap({"#####",  //
                                   "#..??",  //
                                   "#####"},
                                  0.05);
  const MapView view(map);
  const auto frontiers = detectByWavefront(view, {0.075, 0.075}, 0.0);
  ASSERT_THAT(frontiers, SizeIs(1));
  EXPECT_THAT(frontiers[0].cells, ElementsAre(Cell(3, 1)));
}

TEST(Frontiers, NothingLeaksThroughTheCornersOfAWall) {
  const auto map = test::drawnMap({"####?",  //
                                   "#.#.#",  //
                                   "##.##",  //
                                   "#####"},
                                  0.05);
  // Free cells above the slanting wall touch that below it by a corner only.
  EXPECT_THAT(detectByWavefront(MapView(map), {0.125, 0.075}, 0.0), IsEmpty());
  EXPECT_THAT(allFrontierCells(MapView(map)), IsEmpty());
  EXPECT_THAT(detectByWavefront(MapView(map), {0.175, 0.125}, 0.0), IsEmpty());
}

TEST(Frontiers, BeyondTheEdgeOfTheMapAllIsUnknown) {
  const auto map = test::drawnMap({"####",  //
                                   "#...",  //
                                   "####"},
                                  0.05);
  const MapView view(map);
  const auto frontiers = detectByWavefront(view, {0.075, 0.075}, 0.0);
  ASSERT_THAT(frontiers, SizeIs(1));
  EXPECT_THAT(frontiers[0].cells, ElementsAre(Cell(4, 1)));
  EXPECT_THAT(allFrontierCells(view), ElementsAre(Cell(4, 1)));
}

TEST(Frontiers, AnEmptyMapAndAWalledOneHaveNone) {
  const grid::OccupancyGrid nothing;
  EXPECT_THAT(detectByWavefront(MapView(nothing), {0.0, 0.0}, 0.2), IsEmpty());
  const auto closed = test::drawnMap({"###", "#.#", "###"}, 0.05);
  EXPECT_THAT(detectByWavefront(MapView(closed), {0.075, 0.075}, 0.2), IsEmpty());
}

TEST(Frontiers, ValuesBetweenFreeAndOccupiedAreUnknown) {
  auto map = test::drawnMap({"###", "#..", "###"}, 0.05);
  map.at({2, 1}) = 50;
  const auto frontiers = detectByWavefront(MapView(map), {0.075, 0.075}, 0.0);
  ASSERT_THAT(frontiers, SizeIs(1));
  EXPECT_THAT(frontiers[0].cells, ElementsAre(Cell(2, 1)));
}

TEST(Frontiers, TheCentroidOfABentOneLiesOnIt) {
  const auto map = test::drawnMap({"???????",  //
                                   "?.....?",  //
                                   "?.....?",  //
                                   "?.....?",  //
                                   "#######"},
                                  0.05);
  const MapView view(map);
  const auto frontiers = detectByWavefront(view, {0.175, 0.125}, 0.0);
  ASSERT_THAT(frontiers, SizeIs(1));
  EXPECT_TRUE(liesOn(frontiers[0], view, frontiers[0].centroid));
}

// Others leave the first cell out of the sum and divide by the count of all: 15 cells at 20 m then
// have their middle at 19 m.
TEST(Frontiers, TwentyMetresFromTheOriginTheCentroidStillLiesOnTheFrontier) {
  std::vector<std::string> rows(17, std::string(60, '.') + "?");
  rows.front() = rows.back() = std::string(61, '#');
  auto map = test::drawnMap(rows, 0.05);
  map.geometry.origin = {17.35, 19.8};
  const MapView view(map);
  FastDetector detector;
  detector.searchAll(view);
  const Survey survey(map, {}, {18.0, 20.2, 0.0}, 0.2, 4.0);
  std::size_t looked_at = 0;
  for (const auto& [id, frontier] : detector.store().all()) {
    EXPECT_TRUE(liesOn(frontier, view, frontier.centroid));
    if (frontier.centroid.x() > 20.0) {
      EXPECT_NEAR(frontier.centroid.x(), 20.375, 1e-9);
      EXPECT_NEAR(frontier.centroid.y(), 20.225, 1e-9);
      const auto option = survey.optionFor(frontier, {});
      ASSERT_TRUE(option);
      EXPECT_NEAR(option->viewpoint.T_map_base.x, 20.375, 0.35);
      EXPECT_NEAR(option->viewpoint.T_map_base.theta, 0.0, 0.2);
      ++looked_at;
    }
  }
  EXPECT_EQ(looked_at, 1U);
}

TEST(FrontierStore, AFrontierKeepsItsIdWhileItGrowsAndMoves) {
  const auto first = test::drawnMap({"????", "....", "####"}, 0.05);
  const auto second = test::drawnMap({"????", "?..?", "....", "####"}, 0.05);
  FastDetector detector;
  detector.searchAll(MapView(first));
  const FrontierId id = detector.store().ownerOf({1, 2});
  ASSERT_NE(id, 0U);
  detector.searchAll(MapView(second));
  EXPECT_EQ(detector.store().ownerOf({1, 3}), id);
}

TEST(FrontierStore, OfTwoPartsTheLargerKeepsTheIdAndTheOtherGetsANewOne) {
  const auto whole = test::drawnMap({"???????", ".......", "#######"}, 0.05);
  const auto parted = test::drawnMap({"##??###", ".......", "#######"}, 0.05);
  auto two = test::drawnMap({"?##????", ".......", "#######"}, 0.05);
  FastDetector detector;
  detector.searchAll(MapView(whole));
  const FrontierId id = detector.store().ownerOf({3, 2});
  two.at({0, 1}) = two.at({6, 1}) = grid::kFree;
  detector.searchAll(MapView(two));
  EXPECT_EQ(detector.store().ownerOf({5, 2}), id);
  EXPECT_GT(detector.store().ownerOf({0, 2}), id);
  detector.searchAll(MapView(parted));
  EXPECT_NE(detector.store().ownerOf({2, 2}), 0U);
}

TEST(FrontierStore, FrontiersFollowAMapThatMoves) {
  const auto before = test::drawnMap({"????", "....", "####"}, 0.05);
  auto after = test::drawnMap({"????", "....", "####"}, 0.05);
  after.geometry.origin = {1.0, 0.5};
  FastDetector detector;
  detector.searchAll(MapView(before));
  const FrontierId id = detector.store().ownerOf({1, 2});
  detector.move(geometry::MapMotion({{0.1, 0.1, 0.0}}, {{1.1, 0.6, 0.0}}), MapView(before));
  detector.searchAll(MapView(after));
  EXPECT_EQ(detector.store().ownerOf({21, 12}), id);
}

}  // namespace
}  // namespace omega_slam::exploration

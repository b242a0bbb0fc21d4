#include "omega_slam/exploration/travel_field.h"

#include <gtest/gtest.h>

#include "omega_slam/exploration/own_place.h"
#include "omega_slam/exploration/viewpoint.h"
#include "support/drawn_map.h"

namespace omega_slam::exploration {
namespace {

std::vector<std::string> roomWithWall() {
  std::vector<std::string> rows(40, "#" + std::string(58, '.') + "#");
  rows.front() = rows.back() = std::string(60, '#');
  for (std::size_t row = 0; row < 25; ++row) {
    rows[row][30] = '#';  // from above to within a metre of the floor
  }
  return rows;
}

TEST(StandingRoom, KeepsTheWidthOfTheRobotFromAllThatIsNotFree) {
  const auto map = test::drawnMap(roomWithWall(), 0.05);
  const MapView view(map);
  const StandingRoom room(view, 0.2);
  EXPECT_TRUE(room.hasRoomAt({5, 5}));    // 5 cells from the wall's cell: its edge is 0.225 m away
  EXPECT_FALSE(room.hasRoomAt({4, 5}));   // 0.175 m
  EXPECT_FALSE(room.hasRoomAt({-3, 5}));  // beyond the edge
  EXPECT_FALSE(room.hasRoomAt({27, 35}));
}

TEST(TravelField, GoesAroundWalls) {
  const auto map = test::drawnMap(roomWithWall(), 0.05);
  const MapView view(map);
  const StandingRoom room(view, 0.2);
  const TravelField field(room, {0.525, 1.525}, 0.0);
  const auto straight = field.distanceTo({20, 30});
  ASSERT_TRUE(straight);
  EXPECT_NEAR(*straight, 0.5, 1e-9);
  const auto around = field.distanceTo({50, 30});
  ASSERT_TRUE(around);
  EXPECT_GT(*around, 2.5);  // 2 m as the crow flies
  EXPECT_LT(*around, 3.6);
}

TEST(TravelField, ItsPathsLeadFromTheStartWithRoomAllTheWay) {
  const auto map = test::drawnMap(roomWithWall(), 0.05);
  const MapView view(map);
  const StandingRoom room(view, 0.2);
  const TravelField field(room, {0.525, 1.525}, 0.0);
  const auto path = field.pathTo({50, 30});
  ASSERT_FALSE(path.empty());
  EXPECT_EQ(view.cellAt(path.front()), Cell(10, 30));
  EXPECT_EQ(view.cellAt(path.back()), Cell(50, 30));
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    EXPECT_TRUE(room.hasRoomAt(view.cellAt(path[i])));
    length += (path[i + 1] - path[i]).norm();
  }
  EXPECT_NEAR(length, field.distanceTo({50, 30}).value(), 0.02 * length);
}

TEST(TravelField, ARobotTooCloseToAWallBeginsWhereThereIsRoom) {
  const auto map = test::drawnMap(roomWithWall(), 0.05);
  const MapView view(map);
  const StandingRoom room(view, 0.2);
  EXPECT_FALSE(TravelField(room, {0.1, 1.0}, 0.0).distanceTo({20, 20}));
  EXPECT_TRUE(TravelField(room, {0.1, 1.0}, 0.3).distanceTo({20, 20}));
}

TEST(TravelField, NoWayIsNone) {
  auto rows = roomWithWall();
  for (std::string& row : rows) {
    row[30] = '#';
  }
  const auto map = test::drawnMap(rows, 0.05);
  const MapView view(map);
  const StandingRoom room(view, 0.2);
  const TravelField field(room, {0.525, 1.525}, 0.0);
  EXPECT_FALSE(field.distanceTo({50, 30}));
  EXPECT_TRUE(field.pathTo({50, 30}).empty());
}

TEST(OwnPlace, IsFreeAndGrowsTheMapWhereItMust) {
  const auto map = test::drawnMap({"???", "?..", "###"}, 0.05);
  const auto own = withOwnPlaceFree(map, {0.025, 0.075}, 0.1);
  const MapView view(own);
  EXPECT_EQ(view.at({-2, 1}), CellState::kFree);
  EXPECT_EQ(view.at({0, 2}), CellState::kFree);
  EXPECT_EQ(view.at({0, 0}), CellState::kOccupied);  // what was seen counts
  EXPECT_EQ(view.at({2, 1}), CellState::kFree);
  EXPECT_EQ(MapView(map).at({-2, 1}), CellState::kUnknown);
}

TEST(Viewpoint, LooksAtTheFrontierFromWhereThereIsRoom) {
  auto rows = roomWithWall();
  for (std::size_t row = 30; row < 38; ++row) {
    rows[row][59] = '?';
  }
  const auto map = test::drawnMap(rows, 0.05);
  const MapView view(map);
  const StandingRoom room(view, 0.2);
  const TravelField field(room, {0.525, 1.525}, 0.0);
  const auto frontier = clusterFrontiers({{59, 3}, {59, 4}, {59, 5}, {59, 6}, {59, 7}}, view).at(0);
  const auto viewpoint = findViewpoint(frontier, view, field, {}, 2.0);
  ASSERT_TRUE(viewpoint);
  const Cell cell = view.cellAt(viewpoint->T_map_base.translation());
  EXPECT_TRUE(room.hasRoomAt(cell));
  EXPECT_NEAR(viewpoint->T_map_base.x, 2.725, 0.06);
  EXPECT_NEAR(viewpoint->T_map_base.theta, 0.0, 0.3);
  const Eigen::Vector2d first = viewpoint->T_map_base.translation();
  const auto second = findViewpoint(frontier, view, field, {first}, 2.0);
  ASSERT_TRUE(second);
  EXPECT_GE((second->T_map_base.translation() - first).norm(), 0.3);
  EXPECT_FALSE(findViewpoint(frontier, view, field, {}, 0.1));
}

TEST(Viewpoint, IsNotBehindAWall) {
  const auto map = test::drawnMap({"...", "###", "..."}, 0.05);
  const MapView view(map);
  EXPECT_FALSE(isInSight(view, {1, 0}, {1, 2}));
  EXPECT_TRUE(isInSight(view, {0, 0}, {2, 0}));
  EXPECT_TRUE(isInSight(view, {1, 0}, {1, 1}));  // what it looks at may be anything
}

}  // namespace
}  // namespace omega_slam::exploration

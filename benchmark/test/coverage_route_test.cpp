#include "maps/coverage_route.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "maps/floor_plan.h"
#include "support/drawn_map.h"

namespace omega_slam::experiments {
namespace {

using grid::Cell;

/// Two rooms of 4 m x 4 m with a door of 1 m between them, and a closet that is closed.
grid::OccupancyGrid twoRooms() {
  grid::OccupancyGrid map = grid::makeGrid({0.1, {0.0, 0.0}, 100, 42}, grid::kOccupied);
  const auto clear = [&map](const Cell& low, const Cell& high) {
    for (int y = low.y(); y < high.y(); ++y) {
      for (int x = low.x(); x < high.x(); ++x) {
        map.at({x, y}) = grid::kFree;
      }
    }
  };
  clear({1, 1}, {41, 41});
  clear({43, 1}, {83, 41});
  clear({41, 15}, {43, 25});
  clear({85, 1}, {99, 41});
  return map;
}

TEST(CoverageRoute, SeesAllThatCanBeReachedAndComesHome) {
  const grid::OccupancyGrid map = twoRooms();
  const CoverageRoute route = planCoverage(map, {1.0, 1.0});
  EXPECT_GT(route.seen, 0.99);
  EXPECT_EQ(route.waypoints.front(), route.waypoints.back());
  EXPECT_LT((route.start - Eigen::Vector2d(1.0, 1.0)).norm(), 0.1);
  bool was_in_second_room = false;
  for (const Eigen::Vector2d& waypoint : route.waypoints) {
    was_in_second_room = was_in_second_room || waypoint.x() > 4.3;
    EXPECT_LT(waypoint.x(), 8.3);  // never in the closet
  }
  EXPECT_TRUE(was_in_second_room);
}

TEST(CoverageRoute, KeepsItsDistance) {
  const grid::OccupancyGrid map = twoRooms();
  const CoverageConfig config;
  const FloorPlan plan(map, config.room);
  const std::vector<Eigen::Vector2d> way = planCoverage(map, {1.0, 1.0}).waypoints;
  for (std::size_t k = 1; k < way.size(); ++k) {
    EXPECT_GE(plan.clearanceAlong(map.geometry.cellAt(way[k - 1]), map.geometry.cellAt(way[k])),
              0.9 * config.room);
  }
}

TEST(CoverageRoute, IsTheSameEachTime) {
  const grid::OccupancyGrid map = twoRooms();
  EXPECT_EQ(planCoverage(map, {1.0, 1.0}).waypoints, planCoverage(map, {1.0, 1.0}).waypoints);
}

TEST(CoverageRoute, ARobotThatFitsNowhereIsAnError) {
  const grid::OccupancyGrid narrow = test::drawnMap({"#####", "#...#", "#####"}, 0.1);
  EXPECT_THROW(static_cast<void>(planCoverage(narrow, {0.2, 0.1})), std::runtime_error);
}

TEST(FloorPlan, SeesNoFartherThanWallsAndRange) {
  const grid::OccupancyGrid map = twoRooms();
  const FloorPlan plan(map, 0.3);
  const double all_round = 3.14159;
  const auto sees = [&](const Cell& cell, const std::vector<std::size_t>& visible) {
    return std::binary_search(visible.begin(), visible.end(), map.geometry.index(cell));
  };
  const auto visible = plan.visibleFrom({20, 35}, 3.0, 0.0, all_round);
  EXPECT_TRUE(sees({10, 35}, visible));
  EXPECT_FALSE(sees({60, 35}, visible));  // behind the wall
  EXPECT_FALSE(sees({20, 3}, visible));   // too far
  const auto ahead = plan.visibleFrom({20, 35}, 3.0, 0.0, 0.5);
  EXPECT_TRUE(sees({30, 35}, ahead));
  EXPECT_FALSE(sees({10, 35}, ahead));
}

TEST(FloorPlan, ClearanceIsFromEdgeToEdge) {
  const FloorPlan plan(twoRooms(), 0.3);
  EXPECT_NEAR(plan.clearance({1, 20}), 0.05, 1e-6);
  EXPECT_NEAR(plan.clearance({10, 20}), 0.95, 1e-6);
  EXPECT_EQ(plan.clearance({0, 0}), 0.0);
  EXPECT_EQ(plan.clearance({-5, 3}), 0.0);
}

}  // namespace
}  // namespace omega_slam::experiments

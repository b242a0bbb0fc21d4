#include "omega_slam/matching/local_map.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

/// Value of a level's cell at a place of the map; 0 outside of the window.
double valueAt(const LocalMap& map, std::size_t level, const Eigen::Vector2d& p_map) {
  const ValueGrid& grid = map.grids()[level];
  const grid::Cell cell = grid.geometry.cellAt(p_map);
  return grid.geometry.contains(cell) ? grid.values[grid.geometry.index(cell)] : 0.0;
}

View viewOf(const Points& points, const Eigen::Vector2d& origin = {0.0, 0.0}) {
  return {points, origin};
}

LocalMapConfig smallMap() {
  LocalMapConfig config;
  config.resolution = 0.1;
  config.levels = 3;
  return config;
}

TEST(LocalMap, EndOfABeamIsOccupiedAndItsWayIsNot) {
  LocalMap map(smallMap());
  ASSERT_TRUE(map.insert(viewOf({{2.05, 0.05}}), {}));
  for (std::size_t level = 0; level < 3; ++level) {
    EXPECT_GT(valueAt(map, level, {2.05, 0.05}), 0.7 * ValueGrid::kMost) << level;
  }
  for (const double x : {0.05, 0.55, 1.05, 1.95, 2.15}) {
    EXPECT_EQ(valueAt(map, 0, {x, 0.05}), 0.0) << x;
  }
}

TEST(LocalMap, SeenAgainIsMoreLikely) {
  LocalMap map(smallMap());
  ASSERT_TRUE(map.insert(viewOf({{2.05, 0.05}}), {}));
  const double once = valueAt(map, 0, {2.05, 0.05});
  ASSERT_TRUE(map.insert(viewOf({{2.05, 0.05}}), {}));
  EXPECT_GT(valueAt(map, 0, {2.05, 0.05}), once);
}

TEST(LocalMap, ViewCountsOnceInACell) {
  LocalMap one(smallMap());
  LocalMap many(smallMap());
  ASSERT_TRUE(one.insert(viewOf({{2.05, 0.05}}), {}));
  ASSERT_TRUE(many.insert(viewOf(Points(20, {2.05, 0.05})), {}));
  EXPECT_EQ(valueAt(many, 0, {2.05, 0.05}), valueAt(one, 0, {2.05, 0.05}));
}

TEST(LocalMap, EndWinsOverTheWayOfAnotherBeam) {
  LocalMap map(smallMap());
  ASSERT_TRUE(map.insert(viewOf({{3.05, 0.05}, {2.05, 0.05}, {4.05, 0.05}}), {}));
  EXPECT_GT(valueAt(map, 0, {2.05, 0.05}), 0.7 * ValueGrid::kMost);
}

TEST(LocalMap, WhatIsSeenThroughIsForgotten) {
  LocalMap map(smallMap());
  ASSERT_TRUE(map.insert(viewOf({{2.05, 0.05}}), {}));
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(map.insert(viewOf({{4.05, 0.05}}), {}));
  }
  for (std::size_t level = 0; level < 3; ++level) {
    EXPECT_EQ(valueAt(map, level, {2.05, 0.05}), 0.0) << level;
  }
}

TEST(LocalMap, WallGoesOnBetweenReturnsCloseTogether) {
  LocalMap map(smallMap());
  ASSERT_TRUE(map.insert(viewOf({{2.05, 0.03}, {2.05, 0.21}, {2.05, 1.05}}), {}));
  EXPECT_GT(valueAt(map, 0, {2.05, 0.15}), 0.0);
  EXPECT_EQ(valueAt(map, 0, {2.05, 0.65}), 0.0) << "too far apart";
}

TEST(LocalMap, StandsWhereItsPoseSays) {
  LocalMap map(smallMap());
  // The laser stands 1 m before the frame of the view, which looks along y.
  ASSERT_TRUE(map.insert(viewOf({{3.05, 0.05}}, {1.0, 0.0}), {-2.0, 5.0, M_PI / 2.0}));
  EXPECT_GT(valueAt(map, 0, {-2.05, 8.05}), 0.0);
  EXPECT_EQ(map.recentViews().back().origin.y(), 6.0);
}

TEST(LocalMap, ReturnsOutOfReachAreLeftOut) {
  LocalMapConfig config = smallMap();
  config.reach = 3.0;
  LocalMap map(config);
  ASSERT_TRUE(map.insert(viewOf({{2.95, 0.05}, {3.55, 0.55}}), {}));
  EXPECT_EQ(map.recentViews().back().points.size(), 1U);
  EXPECT_EQ(valueAt(map, 0, {3.55, 0.55}), 0.0);
}

TEST(LocalMap, WindowFollowsTheRobotAndStaysBounded) {
  LocalMapConfig config = smallMap();
  config.reach = 5.0;
  LocalMap map(config);
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(map.insert(viewOf({{4.0, 1.0}}), {1.0 * i, 0.0, 0.0}));
    EXPECT_GT(valueAt(map, 0, {1.0 * i + 4.0, 1.0}), 0.0) << i;
    const auto& geometry = map.grids().front().geometry;
    EXPECT_LE(std::max(geometry.width, geometry.height), (4.0 * 5.0 + 2.0) / 0.1);
  }
}

TEST(LocalMap, KnowsWhatIsInReachAndForgetsWhatIsFarBehind) {
  LocalMapConfig config = smallMap();
  config.reach = 5.0;
  LocalMap map(config);
  ASSERT_TRUE(map.insert(viewOf({{0.05, 2.05}}), {}));
  for (const double x : {3.0, 6.0, 9.0}) {
    ASSERT_TRUE(map.insert(viewOf({{4.0, 1.0}}), {x, 0.0, 0.0}));
    for (std::size_t level = 0; level < 3; ++level) {
      EXPECT_GT(valueAt(map, level, {0.05, 2.05}), 0.0) << x << ", " << level;
    }
  }
  for (const double x : {30.0, 15.0, 5.0}) {  // away, and back
    ASSERT_TRUE(map.insert(viewOf({{-4.0, 1.0}, {4.0, 1.0}}), {x, 0.0, 0.0}));
  }
  EXPECT_EQ(valueAt(map, 0, {0.05, 2.05}), 0.0);
}

TEST(LocalMap, BelievesWhatHasChangedAfterSomeViews) {
  LocalMap map(smallMap());
  const View wall = viewOf({{2.05, 0.05}});
  const View behind = viewOf({{4.05, 0.05}});
  const auto put = [&map](const View& view, int times) {
    for (int i = 0; i < times; ++i) {
      ASSERT_TRUE(map.insert(view, {}));
    }
  };
  put(behind, 1000);
  put(wall, 4);
  EXPECT_GT(valueAt(map, 0, {2.05, 0.05}), 0.0);
  put(wall, 1000);
  put(behind, 16);
  EXPECT_EQ(valueAt(map, 0, {2.05, 0.05}), 0.0);
}

TEST(LocalMap, RemembersTheNewestViews) {
  LocalMap map(smallMap());
  for (int i = 0; i < 30; ++i) {
    ASSERT_TRUE(map.insert(viewOf({{2.0, 0.0}}), {0.1 * i, 0.0, 0.0}));
  }
  EXPECT_EQ(map.recentViews().size(), LocalMap::kRecentViews);
  EXPECT_DOUBLE_EQ(map.recentViews().front().origin.x(), 1.0);
  EXPECT_DOUBLE_EQ(map.recentViews().back().origin.x(), 2.9);
}

TEST(LocalMap, ClearForgetsEverything) {
  LocalMap map(smallMap());
  ASSERT_TRUE(map.insert(viewOf({{2.05, 0.05}}), {}));
  map.clear();
  EXPECT_TRUE(map.recentViews().empty());
  EXPECT_EQ(valueAt(map, 0, {2.05, 0.05}), 0.0);
  EXPECT_EQ(map.config().resolution, 0.1);
}

}  // namespace
}  // namespace omega_slam::matching

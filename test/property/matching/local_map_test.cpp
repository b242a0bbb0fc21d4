#include "omega_slam/matching/local_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

LocalMapConfig smallMap() {
  LocalMapConfig config;
  config.resolution = 0.05;
  config.levels = 3;
  return config;
}

/// Views of the furnished room from places in it, in the room's frame.
Reference viewsOfTheRoom(int count, std::mt19937_64& random) {
  Reference views;
  for (int i = 0; i < count; ++i) {
    const Pose2 T_room_laser = test::randomPose(0.8, 3.1, random);
    const View view{test::measurePoints(test::furnishedRoom(), T_room_laser, 180, 0.02, random),
                    {0.0, 0.0}};
    views.push_back(transformed(T_room_laser, view));
  }
  return views;
}

void expectSameMap(const LocalMap& a, const LocalMap& b) {
  for (std::size_t level = 0; level < a.grids().size(); ++level) {
    const ValueGrid& grid = a.grids()[level];
    const ValueGrid& other = b.grids()[level];
    std::size_t occupied = 0;
    for (int y = 0; y < grid.geometry.height; ++y) {
      for (int x = 0; x < grid.geometry.width; ++x) {
        const int value = grid.values[grid.geometry.index({x, y})];
        const grid::Cell there = other.geometry.cellAt(grid.geometry.center({x, y}));
        const bool is_inside = other.geometry.contains(there);
        ASSERT_EQ(value, is_inside ? other.values[other.geometry.index(there)] : 0)
            << level << ": " << x << ", " << y;
        occupied += value > 0 ? 1 : 0;
      }
    }
    EXPECT_GT(occupied, 20U);
  }
}

TEST(LocalMapLaws, OrderOfTheViewsDoesNotMatter) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    Reference views = viewsOfTheRoom(6, random);
    const LocalMap map(smallMap(), views);
    std::shuffle(views.begin(), views.end(), random);
    expectSameMap(map, LocalMap(smallMap(), views));
  }
}

TEST(LocalMapLaws, GrownViewByViewItIsTheSame) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    LocalMap grown(smallMap());
    const Reference views = viewsOfTheRoom(4, random);
    for (const View& view : views) {
      ASSERT_TRUE(grown.insert(view, {}));
    }
    expectSameMap(LocalMap(smallMap(), views), grown);
  }
}

TEST(LocalMapLaws, MovingTheWindowChangesNothing) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    LocalMap grown(smallMap());
    Reference views;
    for (int i = 0; i < 6; ++i) {  // rooms beside each other, farther than the margin
      const Pose2 T_map_room{3.0 * i, -2.0 * i, 0.5 * i};
      views.push_back(transformed(T_map_room, viewsOfTheRoom(1, random).front()));
      ASSERT_TRUE(grown.insert(views.back(), {}));
    }
    const LocalMap fresh(smallMap(), views);
    expectSameMap(grown, fresh);
    expectSameMap(fresh, grown);
  }
}

TEST(LocalMapLaws, RedrawnItIsAsNew) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    LocalMap map(smallMap());
    for (const double away : {0.0, 0.7, 25.0}) {  // within the window and beyond it
      Reference views = viewsOfTheRoom(4, random);
      for (View& view : views) {
        view = transformed({away, -away, 0.1}, view);
      }
      map.redraw(views);
      const LocalMap fresh(smallMap(), views);
      expectSameMap(map, fresh);
      expectSameMap(fresh, map);
      EXPECT_EQ(map.recentViews().size(), fresh.recentViews().size());
      ASSERT_TRUE(map.insert(viewsOfTheRoom(1, random).front(), {away + 2.0, -away, 0.0}));
    }
    map.redraw({});
    EXPECT_TRUE(map.recentViews().empty());
  }
}

TEST(LocalMapLaws, CoarseCellIsTheMostLikelyOfTheFourItCovers) {
  std::mt19937_64 random(1);
  const LocalMap map(smallMap(), viewsOfTheRoom(5, random));
  for (std::size_t level = 1; level < map.grids().size(); ++level) {
    const ValueGrid& fine = map.grids()[level - 1];
    const ValueGrid& coarse = map.grids()[level];
    for (int y = 0; y < coarse.geometry.height; ++y) {
      for (int x = 0; x < coarse.geometry.width; ++x) {
        int most = 0;
        for (const grid::Cell& corner : {grid::Cell(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
          const grid::Cell cell = 2 * grid::Cell(x, y) + corner;
          most = std::max<int>(most, fine.values[fine.geometry.index(cell)]);
        }
        ASSERT_EQ(coarse.values[coarse.geometry.index({x, y})], most) << level;
      }
    }
  }
}

TEST(LocalMapLaws, EachReturnIsOccupiedAndNothingFarFromReturnsIs) {
  std::mt19937_64 random(2);
  const Reference views = viewsOfTheRoom(1, random);
  const LocalMap map(smallMap(), views);
  const Points& points = map.recentViews().back().points;
  const ValueGrid& grid = map.grids().front();
  for (const Eigen::Vector2d& point : points) {
    EXPECT_GT(grid.values[grid.geometry.index(grid.geometry.cellAt(point))], 0);
  }
  for (int y = 0; y < grid.geometry.height; ++y) {
    for (int x = 0; x < grid.geometry.width; ++x) {
      if (grid.values[grid.geometry.index({x, y})] == 0) {
        continue;
      }
      const Eigen::Vector2d center = grid.geometry.center({x, y});
      EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const Eigen::Vector2d& point) {
        return (point - center).norm() < 0.15;  // half of the gap that a wall bridges, and a cell
      })) << center.transpose();
    }
  }
}

}  // namespace
}  // namespace omega_slam::matching

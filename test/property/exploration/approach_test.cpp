#include "omega_slam/exploration/approach.h"

#include <gtest/gtest.h>

#include <random>

#include "omega_slam/exploration/survey.h"
#include "support/seeds.h"

namespace omega_slam::exploration {
namespace {

constexpr double kResolution = 0.1;  // [m]
constexpr double kRadius = 0.23;     // [m] of the robot

/// Free, with walls and unknown places of any size all over it.
grid::OccupancyGrid randomMap(std::mt19937_64& random) {
  grid::GridGeometry geometry;
  geometry.resolution = kResolution;
  geometry.width = 60;
  geometry.height = 40;
  grid::OccupancyGrid map = grid::makeGrid(geometry, grid::kFree);
  std::uniform_int_distribution<int> edge(1, 9);
  for (int i = 0; i < 50; ++i) {
    const int width = edge(random);
    const int height = edge(random);
    const int left = std::uniform_int_distribution<int>(0, geometry.width - width)(random);
    const int low = std::uniform_int_distribution<int>(0, geometry.height - height)(random);
    for (int y = low; y < low + height; ++y) {
      for (int x = left; x < left + width; ++x) {
        map.at({x, y}) = i % 3 == 0 ? grid::kUnknown : grid::kOccupied;
      }
    }
  }
  return map;
}

std::vector<Frontier> frontiersOf(const MapView& view) {
  std::vector<Cell> cells;
  for (int y = -1; y <= view.geometry().height; ++y) {
    for (int x = -1; x <= view.geometry().width; ++x) {
      if (view.isFrontier({x, y})) {
        cells.emplace_back(x, y);
      }
    }
  }
  return clusterFrontiers(cells, view);
}

/// Whether the robot can stand so that it almost touches a cell of the frontier that it sees, tried
/// from everywhere.
bool canStandAt(const Frontier& frontier, const MapView& view, const TravelField& travel) {
  for (int y = 0; y < view.geometry().height; ++y) {
    for (int x = 0; x < view.geometry().width; ++x) {
      for (const Cell& cell : frontier.cells) {
        if (travel.distanceTo({x, y}) && isInSight(view, {x, y}, cell) &&
            (cell - Cell(x, y)).cast<double>().norm() * kResolution < kRadius + 0.15) {
          return true;
        }
      }
    }
  }
  return false;
}

TEST(CanComeUpTo, LeavesNoFrontierAloneThatTheRobotCanGetTo) {
  int reachable = 0;
  int in_gaps = 0;
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 8; ++i) {
      const grid::OccupancyGrid map = randomMap(random);
      const MapView view(map);
      const StandingRoom room(view, kRadius);
      const Eigen::Vector2d start(3.0, 2.0);
      const TravelField travel(room, start, 1.0);
      const Survey survey(map, {}, {start.x(), start.y(), 0.0}, kRadius, 4.0);
      for (const Frontier& frontier : frontiersOf(view)) {
        in_gaps += canComeUpTo(frontier, view, kRadius) ? 0 : 1;
        if (canStandAt(frontier, view, travel)) {
          ++reachable;
          EXPECT_TRUE(canComeUpTo(frontier, view, kRadius));
          EXPECT_TRUE(survey.optionFor(frontier, {}));
        }
      }
    }
  }
  EXPECT_GT(reachable, 20);
  EXPECT_GT(in_gaps, 20);
}

}  // namespace
}  // namespace omega_slam::exploration

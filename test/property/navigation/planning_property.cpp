#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "omega_slam/navigation/global_planner.h"
#include "omega_slam/navigation/grid_search.h"
#include "support/seeds.h"

namespace omega_slam::navigation {
namespace {

constexpr double kRadius = 0.2;

/// Boxes and holes in a room of 5 by 4 m.
grid::OccupancyGrid clutteredMap(std::mt19937_64& random) {
  grid::OccupancyGrid map = grid::makeGrid({0.05, {-1.3, 0.7}, 100, 80}, grid::kFree);
  std::uniform_int_distribution<int> column(0, 95);
  std::uniform_int_distribution<int> row(0, 75);
  std::uniform_int_distribution<int> size(1, 9);
  for (int box = 0; box < 25; ++box) {
    const grid::Cell low(column(random), row(random));
    const grid::Cell high = (low + grid::Cell(size(random), size(random)))
                                .cwiseMin(grid::Cell(map.geometry.width, map.geometry.height));
    const std::int8_t value = box % 4 == 0 ? grid::kUnknown : grid::kOccupied;
    for (int y = low.y(); y < high.y(); ++y) {
      for (int x = low.x(); x < high.x(); ++x) {
        map.at({x, y}) = value;
      }
    }
  }
  return map;
}

Eigen::Vector2d placeIn(const Costmap& costmap, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const grid::GridGeometry& geometry = costmap.geometry();
  while (true) {
    const double x = share(random) * geometry.width;
    const double y = share(random) * geometry.height;
    const Eigen::Vector2d point = geometry.origin + geometry.resolution * Eigen::Vector2d(x, y);
    if (costmap.isFree(point, kRadius + 0.05)) {
      return point;
    }
  }
}

/// To the nearest square that is not free, by looking at all of them.
double bruteClearance(const grid::OccupancyGrid& map, const Eigen::Vector2d& point) {
  double least = 1e9;
  for (int row = -1; row <= map.geometry.height; ++row) {
    for (int column = -1; column <= map.geometry.width; ++column) {
      const grid::Cell cell(column, row);
      if (!map.geometry.contains(cell) || map.at(cell) != grid::kFree) {
        const double half = 0.5 * map.geometry.resolution;
        const Eigen::Vector2d away = (point - map.geometry.center(cell)).cwiseAbs();
        least = std::min(least, (away.array() - half).cwiseMax(0.0).matrix().norm());
      }
    }
  }
  return least;
}

void expectClear(const grid::OccupancyGrid& map, const Path& path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const int steps = 1 + static_cast<int>((path[i + 1] - path[i]).norm() / 0.02);
    for (int step = 0; step <= steps; ++step) {
      const double share = static_cast<double>(step) / steps;
      const Eigen::Vector2d point = path[i] + share * (path[i + 1] - path[i]);
      ASSERT_GE(bruteClearance(map, point), kRadius - 3e-4);
    }
  }
}

TEST(PlanningProperty, PathsAreFreeAndFoundWhereTheGridHasAWay) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const grid::OccupancyGrid map = clutteredMap(random);
    Costmap costmap{CostmapConfig{}};
    costmap.setMap(map);
    PlannerConfig config;
    for (const std::string& name : plannerNames()) {
      config.planner = name;
      config.iterations = 100;
      config.time_limit = 10.0;
      const GlobalPlanner planner(config, kRadius);
      const Eigen::Vector2d from = placeIn(costmap, random);
      const Eigen::Vector2d to = placeIn(costmap, random);
      const Plan plan = planner.plan(costmap, from, to);
      const auto way = GridSearch(costmap, planner.cost()).find(from, to).path;
      ASSERT_EQ(plan.found(), way.has_value()) << plan.reason;
      if (plan.found()) {
        EXPECT_EQ(plan.path.front(), from);
        EXPECT_EQ(plan.path.back(), to);
        EXPECT_LE(planner.cost().ofPath(costmap, plan.path),
                  1.1 * planner.cost().ofPath(costmap, *way) + 0.05);
        expectClear(map, plan.path);
        EXPECT_EQ(planner.plan(costmap, from, to).path, plan.path) << name << " does not repeat";
      }
    }
  }
}

/// Bellman and Ford's relaxation: slow, and nothing to get wrong.
std::vector<double> relaxedCosts(const Costmap& costmap, const GridSearch& search,
                                 const ClearanceCost& cost, const grid::Cell& start) {
  const grid::GridGeometry& geometry = costmap.geometry();
  std::vector<double> costs(geometry.size(), std::numeric_limits<double>::infinity());
  costs[geometry.index(start)] = 0.0;
  const auto rate = [&](const grid::Cell& cell) {
    return cost.perMetre(costmap.clearance(geometry.center(cell)));
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int i = 0; i < geometry.width * geometry.height; ++i) {
      const grid::Cell cell(i % geometry.width, i / geometry.width);
      for (int step = 0; step < 9; ++step) {
        const grid::Cell way(step % 3 - 1, step / 3 - 1);
        const grid::Cell next = cell + way;
        if (!search.isPassable(cell) || !search.isPassable(next)) {
          continue;
        }
        const double length = geometry.resolution * way.cast<double>().norm();
        const double total = costs[geometry.index(cell)] + 0.5 * length * (rate(cell) + rate(next));
        if (total < costs[geometry.index(next)] - 1e-9) {
          costs[geometry.index(next)] = total;
          changed = true;
        }
      }
    }
  }
  return costs;
}

TEST(PlanningProperty, SearchesFindTheLeastCosts) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    grid::OccupancyGrid map = grid::makeGrid({0.1, {0.0, 0.0}, 24, 18}, grid::kFree);
    std::bernoulli_distribution occupied(0.04);
    for (std::int8_t& cell : map.cells) {
      cell = occupied(random) ? grid::kOccupied : grid::kFree;
    }
    Costmap costmap{CostmapConfig{}};
    costmap.setMap(map);
    const ClearanceCost cost{0.1, 0.4, 2.0};
    const GridSearch search(costmap, cost);
    const Eigen::Vector2d from = map.geometry.center(map.geometry.cellAt(placeIn(costmap, random)));
    const auto expected = relaxedCosts(costmap, search, cost, map.geometry.cellAt(from));
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const int width = map.geometry.width;
      const grid::Cell cell(static_cast<int>(i) % width, static_cast<int>(i) / width);
      const Eigen::Vector2d to = map.geometry.center(cell);
      const SearchOutcome way = search.find(from, to);
      EXPECT_FALSE(way.is_spent);
      if (!search.isPassable(cell) || (to - from).norm() < 1.5 * map.geometry.resolution) {
        continue;  // may be joined to a cell beside it, or straight to the start
      }
      ASSERT_EQ(way.path.has_value(), std::isfinite(expected[i]));
      if (way.path) {
        // Cells beside the start are joined to it straight, which may be a little cheaper.
        EXPECT_LE(way.cost, expected[i] + 1e-4);
        EXPECT_GE(way.cost, 0.9 * expected[i] - 0.1);
        EXPECT_NEAR(way.cost, cost.ofPath(costmap, *way.path), 0.2 * way.cost + 0.05);
      }
    }
  }
}

}  // namespace
}  // namespace omega_slam::navigation

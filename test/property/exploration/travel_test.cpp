#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>

#include "omega_slam/exploration/tour.h"
#include "omega_slam/exploration/travel_field.h"
#include "support/seeds.h"

namespace omega_slam::exploration {
namespace {

grid::OccupancyGrid randomMap(std::mt19937_64& random) {
  grid::GridGeometry geometry;
  geometry.width = 37;
  geometry.height = 23;
  geometry.origin = {-0.7, 0.25};
  grid::OccupancyGrid map = grid::makeGrid(geometry, grid::kFree);
  std::uniform_int_distribution<std::size_t> cell(0, geometry.size() - 1);
  for (int i = 0; i < 60; ++i) {
    map.cells[cell(random)] = i % 2 == 0 ? grid::kOccupied : grid::kUnknown;
  }
  return map;
}

/// As its comment says: from the middle of a cell to all squares that are not free.
bool fits(const grid::OccupancyGrid& map, const Cell& center, double radius) {
  const int reach = static_cast<int>(radius / map.geometry.resolution) + 1;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const Cell cell = center + Cell(x, y);
      const bool is_free = map.geometry.contains(cell) && map.at(cell) == grid::kFree;
      const double gap =
          std::hypot(std::max(0.0, std::abs(x) - 0.5), std::max(0.0, std::abs(y) - 0.5));
      if (!is_free && gap * map.geometry.resolution < radius) {
        return false;
      }
    }
  }
  return true;
}

TEST(StandingRoom, IsWhereTheDiscFits) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const grid::OccupancyGrid map = randomMap(random);
    std::uniform_real_distribution<double> radius(0.03, 0.3);
    const double drawn = radius(random);
    const StandingRoom room(MapView(map), drawn);
    for (int y = -1; y <= map.geometry.height; ++y) {
      for (int x = -1; x <= map.geometry.width; ++x) {
        ASSERT_EQ(room.hasRoomAt(Cell(x, y) + room.corner()), fits(map, {x, y}, drawn));
      }
    }
  }
}

/// Bellman and Ford: relax everything until nothing changes.
std::vector<double> oracle(const StandingRoom& room, const Cell& start) {
  const grid::GridGeometry& geometry = room.geometry();
  std::vector<double> costs(geometry.size(), 1e9);
  costs[geometry.index(start)] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < geometry.height; ++y) {
      for (int x = 0; x < geometry.width; ++x) {
        for (const Cell& step : kNeighbours) {
          const Cell from(x, y);
          const Cell to = from + step;
          const auto open = [&](const Cell& cell) { return room.hasRoomAt(cell + room.corner()); };
          if (!open(from) || !open(to) || !open({to.x(), from.y()}) || !open({from.x(), to.y()})) {
            continue;
          }
          const double cost = costs[geometry.index(from)] + (step.squaredNorm() == 1 ? 1.0 : 1.4);
          if (cost < costs[geometry.index(to)] - 1e-9) {
            costs[geometry.index(to)] = cost;
            changed = true;
          }
        }
      }
    }
  }
  return costs;
}

TEST(TravelField, AgreesWithBellmanAndFord) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const grid::OccupancyGrid map = randomMap(random);
    const MapView view(map);
    const StandingRoom room(view, 0.04);
    Cell start(0, 0);
    while (!room.hasRoomAt(start + room.corner())) {
      start = Cell(start.x() + 1, (start.y() + 5) % map.geometry.height);
    }
    const TravelField field(room, map.geometry.center(start), 0.0);
    const auto costs = oracle(room, start);
    for (int y = 0; y < map.geometry.height; ++y) {
      for (int x = 0; x < map.geometry.width; ++x) {
        const auto distance = field.distanceTo(Cell(x, y) + room.corner());
        const double expected = costs[map.geometry.index({x, y})];
        ASSERT_EQ(distance.has_value(), expected < 1e8);
        if (distance) {
          ASSERT_NEAR(*distance, expected * map.geometry.resolution, 1e-6);
        }
      }
    }
  }
}

/// The best tour that begins with the stop, by trying all orders of the others: its length, and the
/// ways until its stops are reached.
double bestCost(const TourCosts& costs, double eagerness, std::size_t first) {
  std::vector<std::size_t> order(costs.start.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::swap(order[0], order[first]);
  std::sort(order.begin() + 1, order.end());
  double best = std::numeric_limits<double>::infinity();
  do {
    double length = costs.start[first];
    double arrivals = length;
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
      length += costs.between[order[i]][order[i + 1]];
      arrivals += length;
    }
    best = std::min(best, eagerness * arrivals + length + costs.end[order.back()]);
  } while (std::next_permutation(order.begin() + 1, order.end()));
  return best;
}

TEST(Tour, CostsWhatTryingAllOrdersFinds) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> cost(0.0, 10.0);
    for (std::size_t count = 1; count <= 6; ++count) {
      const auto draw = [&] {
        std::vector<double> drawn(count);
        std::generate(drawn.begin(), drawn.end(), [&] { return cost(random); });
        return drawn;
      };
      TourCosts costs{draw(), {}, draw()};
      std::generate_n(std::back_inserter(costs.between), count, draw);
      const double eagerness = 0.1 * cost(random);
      const std::vector<double> found = costsByFirst(costs, eagerness);
      ASSERT_EQ(found.size(), count);
      for (std::size_t first = 0; first < count; ++first) {
        EXPECT_NEAR(found[first], bestCost(costs, eagerness, first), 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace omega_slam::exploration

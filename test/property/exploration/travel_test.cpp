#include <gtest/gtest.h>

#include <algorithm>
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

double bestLength(const TravelMatrix& travel) {
  std::vector<std::size_t> order(travel.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  double best = lengthOf(order, travel);
  while (std::next_permutation(order.begin() + 1, order.end())) {
    best = std::min(best, lengthOf(order, travel));
  }
  return best;
}

TEST(Tour, IsHardlyLongerThanTheShortestOfAll) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(0.0, 10.0);
    double ratio = 0.0;
    constexpr int kTrials = 30;
    for (int trial = 0; trial < kTrials; ++trial) {
      std::vector<Eigen::Vector2d> stops;
      for (int i = 0; i < 7; ++i) {
        stops.emplace_back(place(random), place(random));
      }
      TravelMatrix travel(stops.size(), std::vector<double>(stops.size()));
      for (std::size_t a = 0; a < stops.size(); ++a) {
        for (std::size_t b = 0; b < stops.size(); ++b) {
          travel[a][b] = (stops[a] - stops[b]).norm();
        }
      }
      auto tour = shortTour(travel);
      const double length = lengthOf(tour, travel);
      ASSERT_EQ(tour.front(), 0U);
      std::sort(tour.begin(), tour.end());
      for (std::size_t i = 0; i < tour.size(); ++i) {
        ASSERT_EQ(tour[i], i);  // every stop once
      }
      ratio += length / bestLength(travel) / kTrials;
    }
    EXPECT_LT(ratio, 1.05);
    EXPECT_GE(ratio, 1.0 - 1e-9);
  }
}

}  // namespace
}  // namespace omega_slam::exploration

// What an Explorer does about nooks, behind which there is little to be seen.
#include <gtest/gtest.h>

#include "omega_slam/exploration/explorer.h"

namespace omega_slam::exploration {
namespace {

using geometry::Pose2;

ExplorerConfig configOf(const std::string& strategy) {
  ExplorerConfig config;
  config.strategy = strategy;
  return config;
}

/// A corridor of 20 m, all known but for a nook of 0.2 m^2 in the wall at its left end.
std::shared_ptr<const grid::OccupancyGrid> corridorWithANook() {
  auto map = std::make_shared<grid::OccupancyGrid>(
      grid::makeGrid({0.1, {0.0, 0.0}, 200, 20}, grid::kFree));
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 200; ++column) {
      const bool is_edge = row == 0 || row == 19 || column <= 4 || column == 199;
      const bool is_nook = column >= 1 && column <= 4 && row >= 8 && row < 13;
      map->at({column, row}) = is_nook ? grid::kUnknown : is_edge ? grid::kOccupied : grid::kFree;
    }
  }
  return map;
}

TEST(Explorer, OnlyATourLeavesOutANookThatIsNotWorthItsWay) {
  for (const char* strategy : {"tour", "nearest_to_robot"}) {
    for (const double x : {15.0, 1.0}) {  // far from it, and right before it
      Explorer explorer(configOf(strategy));
      (void)explorer.start();
      explorer.showMap(corridorWithANook());
      const Order order = explorer.update(0.0, Pose2{x, 1.0, 3.1});
      const bool is_left_out = explorer.strategy() == "tour" && x > 10.0;
      EXPECT_EQ(order.kind == Order::Kind::kGo, !is_left_out) << strategy << " at " << x;
      EXPECT_EQ(explorer.phase() == Phase::kExploring, !is_left_out);
    }
  }
}

TEST(Explorer, ATourIsNotCalledBackFromItsWayHomeByANook) {
  Explorer explorer(configOf("tour"));
  (void)explorer.start();
  explorer.showMap(corridorWithANook());
  (void)explorer.update(0.0, Pose2{15.0, 1.0, 3.1});
  ASSERT_EQ(explorer.phase(), Phase::kReturning);
  explorer.showMap(corridorWithANook());
  (void)explorer.update(1.0, Pose2{15.0, 1.0, 3.1});
  EXPECT_NE(explorer.phase(), Phase::kExploring);
}

}  // namespace
}  // namespace omega_slam::exploration

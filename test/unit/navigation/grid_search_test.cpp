#include "omega_slam/navigation/grid_search.h"

#include <gtest/gtest.h>

#include "support/drawn_map.h"

namespace omega_slam::navigation {
namespace {

const ClearanceCost kCost{0.2, 0.5, 3.0};
const Eigen::Vector2d kStart(1.0, 1.0);

/// A hall of 20 by 20 m with a closed store in a corner.
Costmap hallCostmap() {
  grid::OccupancyGrid map = grid::makeGrid({0.1, {0.0, 0.0}, 200, 200}, grid::kFree);
  for (int i = 0; i < 30; ++i) {
    map.at({i, 170}) = map.at({30, 170 + i}) = grid::kOccupied;
  }
  Costmap costmap{CostmapConfig{}};
  costmap.setMap(map);
  return costmap;
}

const Eigen::Vector2d kStore(1.5, 18.5);
const Eigen::Vector2d kFarCorner(19.0, 19.0);

TEST(GridSearch, EndsWhenItsCellsAreSpent) {
  const Costmap costmap = hallCostmap();
  const SearchOutcome patient = GridSearch(costmap, kCost).find(kStart, kStore);
  EXPECT_FALSE(patient.path.has_value());
  EXPECT_FALSE(patient.is_spent);
  EXPECT_GT(patient.looked, 30000U);
  const SearchOutcome bounded = GridSearch(costmap, kCost, 5000).find(kStart, kStore);
  EXPECT_FALSE(bounded.path.has_value());
  EXPECT_TRUE(bounded.is_spent);
  EXPECT_EQ(bounded.looked, 5000U);
}

/// Cheap ways along the walls of a dead end come first, until there is no time for that.
TEST(GridSearch, MakesForTheGoalWhenHalfOfItsCellsAreSpent) {
  Costmap costmap{CostmapConfig{}};
  costmap.setMap(test::drawnMap({"####################",  //
                                 "#                  #",  //
                                 "#   ############   #",  //
                                 "#              #   #",  //
                                 "#              #   #",  //
                                 "#   ############   #",  //
                                 "#                  #",  //
                                 "####################"},
                                0.05, 20));
  const Eigen::Vector2d from(8.0, 4.0);
  const Eigen::Vector2d to(18.0, 4.0);
  const SearchOutcome best = GridSearch(costmap, kCost).find(from, to);
  ASSERT_TRUE(best.path.has_value());
  const std::size_t few = best.looked * 7 / 8;
  const SearchOutcome hurried = GridSearch(costmap, kCost, few).find(from, to);
  ASSERT_TRUE(hurried.path.has_value());
  EXPECT_LE(hurried.looked, few);
  EXPECT_GE(hurried.cost, best.cost - 1e-4);
  for (std::size_t i = 0; i + 1 < hurried.path->size(); ++i) {
    EXPECT_TRUE(costmap.isFree((*hurried.path)[i], (*hurried.path)[i + 1], kCost.radius));
  }
}

TEST(GridSearch, BeginsWhereThatIsCheapestAltogether) {
  const Costmap costmap = hallCostmap();
  const Eigen::Vector2d near = costmap.geometry().center({20, 100});
  const Eigen::Vector2d far = costmap.geometry().center({180, 100});
  const GridSearch search(costmap, kCost);
  EXPECT_EQ(search.findFromAny({{near, 0.0}, {far, 0.0}}, kFarCorner).path->front(), far);
  EXPECT_EQ(search.findFromAny({{near, 0.0}, {far, 30.0}}, kFarCorner).path->front(), near);
  EXPECT_FALSE(search.findFromAny({}, kFarCorner).path.has_value());
}

}  // namespace
}  // namespace omega_slam::navigation

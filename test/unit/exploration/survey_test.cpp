#include "omega_slam/exploration/survey.h"

#include <gtest/gtest.h>

namespace omega_slam::exploration {
namespace {

/// A hall of 6 by 6 m above a niche, 0.8 m wide and so many cells of 0.1 m deep, with a table leg
/// at each side of its mouth: a robot of 0.23 m fits in there, but not between the legs.
grid::OccupancyGrid nicheOf(int depth) {
  grid::OccupancyGrid map = grid::makeGrid({0.1, {0.0, 0.0}, 60, 60 + depth}, grid::kOccupied);
  for (int row = 1; row < map.geometry.height - 1; ++row) {
    for (int col = 1; col < map.geometry.width - 1; ++col) {
      const bool is_niche = col >= 10 && col < 18;
      map.at({col, row}) = row >= depth || is_niche ? grid::kFree : grid::kOccupied;
    }
  }
  map.at({11, depth}) = map.at({16, depth}) = grid::kOccupied;
  return map;
}

std::optional<double> wayFromTheNiche(int depth) {
  const double y = 0.1 * depth - 0.5;  // the robot looks out
  const Survey survey(nicheOf(depth), {}, {1.4, y, 1.5}, 0.23, 4.0);
  return survey.travelTo({4.0, 0.1 * depth + 4.0});
}

TEST(Survey, ARobotInAPocketGetsOutAsItGotIn) {
  const auto way = wayFromTheNiche(10);
  ASSERT_TRUE(way);
  EXPECT_GT(*way, 3.0);
}

TEST(Survey, FromARoomThereIsNoWayThroughAGapThatIsTooNarrow) { EXPECT_FALSE(wayFromTheNiche(60)); }

}  // namespace
}  // namespace omega_slam::exploration

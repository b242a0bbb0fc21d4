#include "omega_slam/exploration/beyond.h"

#include <gtest/gtest.h>

#include "omega_slam/exploration/frontier.h"
#include "support/drawn_map.h"

namespace omega_slam::exploration {
namespace {

constexpr double kReach = 2.0;  // [m]

/// [m^2] behind the frontier in a map of cells of 0.1 m, for a robot of 0.2 m at a place.
double areaBehind(const std::vector<std::string>& rows, const Eigen::Vector2d& robot) {
  const grid::OccupancyGrid map = test::drawnMap(rows, 0.1);
  const MapView view(map);
  const StandingRoom room(view, 0.2);
  const TravelField travel(room, robot, 0.5);
  std::vector<Cell> cells;
  for (int y = 0; y < map.geometry.height; ++y) {
    for (int x = 0; x < map.geometry.width; ++x) {
      if (view.isFrontier({x, y})) {
        cells.emplace_back(x, y);
      }
    }
  }
  const std::vector<Frontier> frontiers = clusterFrontiers(cells, view);
  EXPECT_EQ(frontiers.size(), 1U);
  return Beyond(view, travel, 0.2).areaBehind(frontiers.at(0), kReach);
}

/// A room of 3 by 1.5 m, whose upper wall is as it is said.
std::vector<std::string> roomBelow(const std::vector<std::string>& rows) {
  std::vector<std::string> all = rows;
  all.insert(all.end(), 15, "#" + std::string(30, '.') + "#");
  all.emplace_back(32, '#');
  return all;
}

constexpr const char* kWall = "################################";

TEST(Beyond, ANookIsAsLargeAsItIs) {
  EXPECT_NEAR(areaBehind(roomBelow({kWall, "##########??????################",
                                    "##########??????################"}),
                         {1.5, 0.7}),
              0.12, 1e-9);
}

TEST(Beyond, BehindADoorItIsAsLargeAsTheReachAllows) {
  std::vector<std::string> rows(20, std::string(32, '?'));
  rows.emplace_back("###########??????????###########");
  EXPECT_GT(areaBehind(roomBelow(rows), {1.5, 0.7}), 2.0);
}

TEST(Beyond, FloorBehindAShadowThatNoOtherWayLeadsToCounts) {
  std::vector<std::string> rows{kWall};
  rows.insert(rows.end(), 15, "#" + std::string(30, '.') + "#");
  rows.emplace_back("###########??????????###########");
  EXPECT_GT(areaBehind(roomBelow(rows), {1.5, 0.7}), 2.0);
}

TEST(Beyond, FloorOnBothSidesOfAShadowThatTheRobotGetsToDoesNotCount) {
  std::vector<std::string> rows{kWall};
  rows.insert(rows.end(), 15, "#" + std::string(30, '.') + "#");
  rows.emplace_back("##........##????################");
  EXPECT_NEAR(areaBehind(roomBelow(rows), {1.5, 0.7}), 0.04, 1e-9);
}

}  // namespace
}  // namespace omega_slam::exploration

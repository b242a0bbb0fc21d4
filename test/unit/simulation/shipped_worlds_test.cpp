#include <gtest/gtest.h>

#include <string>

#include "omega_slam/simulation/route_driver.h"
#include "omega_slam/simulation/turtlebot.h"
#include "omega_slam/simulation/world_file.h"
#include "support/paths.h"

namespace omega_slam::simulation {
namespace {

struct ShippedWorld {
  std::string name;
  double width;       ///< [m]
  double height;      ///< [m]
  double time_limit;  ///< [s] of simulated time for the route
};

class ShippedWorldTest : public ::testing::TestWithParam<ShippedWorld> {};

TEST_P(ShippedWorldTest, ItsRouteIsDrivenWithoutACollision) {
  const ShippedWorld& expected = GetParam();
  const LoadedWorld loaded =
      loadWorld(test::sourceFolder() / "maps" / (expected.name + ".world.yaml"));
  const grid::GridGeometry& geometry = loaded.world->geometry();
  EXPECT_NEAR(geometry.width * geometry.resolution, expected.width, 1e-9);
  EXPECT_NEAR(geometry.height * geometry.resolution, expected.height, 1e-9);
  EXPECT_FALSE(loaded.file.description.empty());

  TurtleBot robot(loaded.world, loaded.file.start, {});
  RouteDriver driver({}, loaded.file.route);
  const double start = robot.time();
  double length = 0.0;
  while (driver.status().state == RouteStatus::State::kDriving &&
         robot.time() - start < expected.time_limit) {
    ASSERT_TRUE(robot.command(driver.update(robot.time(), robot.truth().T_world_base)));
    const geometry::Pose2 before = robot.truth().T_world_base;
    length += geometry::distance(before, robot.step().truth.T_world_base);
    ASSERT_EQ(robot.collisions(), 0)
        << "at (" << before.x << ", " << before.y << "), " << driver.status().toString();
  }
  EXPECT_EQ(driver.status().toString(), "done");
  RecordProperty("seconds", std::to_string(robot.time() - start));
  RecordProperty("metres", std::to_string(length));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedWorldTest,
                         ::testing::Values(ShippedWorld{"lab", 11.0, 18.0, 250.0},
                                           ShippedWorld{"office", 40.0, 25.0, 600.0},
                                           ShippedWorld{"maze", 10.0, 10.0, 600.0},
                                           ShippedWorld{"corridor", 80.3, 2.45, 450.0}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace omega_slam::simulation

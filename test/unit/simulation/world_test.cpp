#include "omega_slam/simulation/world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "omega_slam/geometry/angle.h"
#include "support/drawn_world.h"

namespace omega_slam::simulation {
namespace {

using geometry::kPi;

grid::MapImage rowOfPixels(const std::vector<std::uint8_t>& pixels) {
  grid::MapImage image;
  image.geometry.width = static_cast<int>(pixels.size());
  image.geometry.height = 1;
  image.pixels = pixels;
  return image;
}

TEST(World, ReadsMaterialsFromGreyValues) {
  const World world = World::fromImage(rowOfPixels({0, 32, 64, 80, 205, 254}));
  EXPECT_EQ(world.at({0, 0}), Material::kWall);
  EXPECT_EQ(world.at({1, 0}), Material::kDark);
  EXPECT_EQ(world.at({2, 0}), Material::kGlass);
  EXPECT_EQ(world.at({3, 0}), Material::kWall);
  EXPECT_EQ(world.at({4, 0}), Material::kNone);
  EXPECT_EQ(world.at({5, 0}), Material::kNone);
}

TEST(World, ReadsNegatedImages) {
  grid::MapImage image = rowOfPixels({255, 223, 191, 0});
  image.negate = true;
  const World world = World::fromImage(image);
  EXPECT_EQ(world.at({0, 0}), Material::kWall);
  EXPECT_EQ(world.at({1, 0}), Material::kDark);
  EXPECT_EQ(world.at({2, 0}), Material::kGlass);
  EXPECT_EQ(world.at({3, 0}), Material::kNone);
}

TEST(World, RawMapsAreRefused) {
  grid::MapImage image = rowOfPixels({0, 100});
  image.mode = grid::MapMode::kRaw;
  EXPECT_THROW(World::fromImage(image), std::invalid_argument);
}

TEST(World, EveryMaterialIsOccupiedForMapServer) {
  const grid::OccupancyGrid grid = grid::toOccupancyGrid(rowOfPixels({0, kDarkGrey, kGlassGrey}));
  EXPECT_EQ(grid.cells, std::vector<std::int8_t>(3, grid::kOccupied));
}

TEST(World, RejectsCellsThatDoNotFillTheGrid) {
  grid::GridGeometry geometry;
  geometry.width = 2;
  geometry.height = 2;
  EXPECT_THROW(World(geometry, std::vector<Material>(3)), std::invalid_argument);
  geometry.width = 0;
  EXPECT_THROW(World(geometry, {}), std::invalid_argument);
}

TEST(World, RayMeasuresToTheNearSideOfAWall) {
  const auto world = test::drawnWorld({"....#", "....."}, 0.5);
  const auto hit = world->castRay({0.25, 0.75}, 0.0, 10.0);
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->range, 1.75);
  EXPECT_EQ(hit->material, Material::kWall);
  EXPECT_FALSE(world->castRay({0.25, 0.25}, 0.0, 10.0));
}

TEST(World, RayEndsAtItsRange) {
  const auto world = test::drawnWorld({"....#"}, 0.5);
  EXPECT_TRUE(world->castRay({0.25, 0.25}, 0.0, 1.76));
  EXPECT_FALSE(world->castRay({0.25, 0.25}, 0.0, 1.74));
}

TEST(World, RaysGoInEveryDirection) {
  const auto world = test::emptyRoom(2.0);
  EXPECT_NEAR(world->castRay({0.5, 0.0}, 0.0, 9.0)->range, 1.5, 1e-9);
  EXPECT_NEAR(world->castRay({0.5, 0.0}, kPi, 9.0)->range, 2.5, 1e-9);
  EXPECT_NEAR(world->castRay({0.5, 0.3}, kPi / 2, 9.0)->range, 1.7, 1e-9);
  EXPECT_NEAR(world->castRay({0.5, 0.3}, -kPi / 2, 9.0)->range, 2.3, 1e-9);
  EXPECT_NEAR(world->castRay({0.1, 0.0}, kPi / 4, 9.0)->range, 1.9 * std::sqrt(2.0), 1e-9);
}

TEST(World, RayLooksThroughGlassAndSeesWhatIsBehind) {
  const auto world = test::drawnWorld({"..g.d"}, 1.0);
  const auto hit = world->castRay({0.5, 0.5}, 0.0, 10.0);
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->range, 3.5);
  EXPECT_EQ(hit->material, Material::kDark);
}

TEST(World, RayFromInsideOfAWallHasNoLength) {
  const auto world = test::drawnWorld({"#."}, 1.0);
  EXPECT_EQ(world->castRay({0.5, 0.5}, 0.3, 10.0)->range, 0.0);
}

TEST(World, RayFromOutsideFindsTheWorld) {
  const auto world = test::drawnWorld({".#"}, 1.0);
  EXPECT_DOUBLE_EQ(world->castRay({-2.0, 0.5}, 0.0, 10.0)->range, 3.0);
}

TEST(World, NearestObstacleIsThePointOnItsEdge) {
  const auto world = test::drawnWorld({"......", "...#..", "......", "......"}, 1.0);
  const auto point = world->nearestObstacle({2.5, 2.25}, 0.6);
  ASSERT_TRUE(point);
  EXPECT_TRUE(point->isApprox(Eigen::Vector2d(3.0, 2.25)));
  EXPECT_FALSE(world->nearestObstacle({2.5, 2.25}, 0.5));
  const auto corner = world->nearestObstacle({2.7, 1.6}, 0.6);
  ASSERT_TRUE(corner);
  EXPECT_TRUE(corner->isApprox(Eigen::Vector2d(3.0, 2.0)));
}

TEST(World, GlassAndDarkAreSolid) {
  const auto world = test::drawnWorld({"...", ".g.", "...", ".d.", "..."}, 1.0);
  EXPECT_TRUE(world->nearestObstacle({0.9, 3.5}, 0.2));
  EXPECT_TRUE(world->nearestObstacle({0.9, 1.5}, 0.2));
}

TEST(World, OutsideIsSolidHoweverFar) {
  const auto world = test::drawnWorld({"..", ".."}, 1.0);
  EXPECT_TRUE(world->nearestObstacle({0.1, 1.0}, 0.2));
  EXPECT_FALSE(world->nearestObstacle({0.3, 1.0}, 0.2));
  EXPECT_TRUE(world->nearestObstacle({-5.0, 1.0}, 0.2));
  EXPECT_TRUE(world->nearestObstacle({1e300, -1e300}, 0.2));
}

}  // namespace
}  // namespace omega_slam::simulation

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/ray_traversal.h"
#include "omega_slam/simulation/world.h"
#include "support/seeds.h"

namespace omega_slam::simulation {
namespace {

using geometry::kPi;

bool stopsLight(Material material) {
  return material == Material::kWall || material == Material::kDark;
}

World randomWorld(std::mt19937_64& random) {
  grid::GridGeometry geometry;
  geometry.resolution = std::uniform_real_distribution<double>(0.02, 0.3)(random);
  std::uniform_real_distribution<double> shift(-3.0, 3.0);
  geometry.origin = {shift(random), shift(random)};
  geometry.width = std::uniform_int_distribution<int>(1, 60)(random);
  geometry.height = std::uniform_int_distribution<int>(1, 60)(random);
  std::discrete_distribution<int> material{90.0, 6.0, 2.0, 2.0};
  std::vector<Material> cells;
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    cells.push_back(static_cast<Material>(material(random)));
  }
  return World(geometry, std::move(cells));
}

Eigen::Vector2d randomPoint(const grid::GridGeometry& geometry, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(-0.1, 1.1);
  return geometry.origin + geometry.resolution * Eigen::Vector2d(geometry.width * share(random),
                                                                 geometry.height * share(random));
}

/// Length of a ray up to an axis-parallel box, by clipping it at the four sides.
double rangeToBox(const Eigen::Vector2d& origin, double angle, const Eigen::Vector2d& low,
                  double edge) {
  const Eigen::Vector2d heading(std::cos(angle), std::sin(angle));
  const Eigen::Array2d first = (low - origin).array() / heading.array();
  const Eigen::Array2d second = (low - origin).array() / heading.array() + edge / heading.array();
  return std::max(0.0, first.min(second).maxCoeff());
}

TEST(WorldProperty, RayHitsWhatTheExactTraversalMeetsFirst) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 2000; ++i) {
      const World world = randomWorld(random);
      const grid::GridGeometry& geometry = world.geometry();
      const Eigen::Vector2d origin = randomPoint(geometry, random);
      const double angle = std::uniform_real_distribution<double>(-kPi, kPi)(random);
      const double range = std::uniform_real_distribution<double>(0.0, 10.0)(random);
      std::optional<grid::Cell> first;
      grid::traverseRay(geometry, origin,
                        origin + range * Eigen::Vector2d(std::cos(angle), std::sin(angle)),
                        [&](const grid::Cell& cell) {
                          if (!first && stopsLight(world.at(cell))) {
                            first = cell;
                          }
                        });
      const auto hit = world.castRay(origin, angle, range);
      ASSERT_EQ(hit.has_value(), first.has_value());
      if (hit) {
        const Eigen::Vector2d low = geometry.origin + geometry.resolution * first->cast<double>();
        EXPECT_NEAR(hit->range, rangeToBox(origin, angle, low, geometry.resolution), 1e-9);
        EXPECT_EQ(hit->material, world.at(*first));
      }
    }
  }
}

TEST(WorldProperty, NearestObstacleAgreesWithLookingAtEveryCell) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 300; ++i) {
      const World world = randomWorld(random);
      const grid::GridGeometry& geometry = world.geometry();
      const Eigen::Vector2d center = randomPoint(geometry, random);
      const double radius = std::uniform_real_distribution<double>(0.01, 0.5)(random);
      // A rim of solid cells stands for the outside.
      const int rim = static_cast<int>(std::ceil(radius / geometry.resolution)) + 1;
      double nearest = radius;
      for (int row = -rim; row < geometry.height + rim; ++row) {
        for (int column = -rim; column < geometry.width + rim; ++column) {
          const grid::Cell cell(column, row);
          if (geometry.contains(cell) && world.at(cell) == Material::kNone) {
            continue;
          }
          const Eigen::Array2d gap =
              ((center - geometry.center(cell)).array().abs() - 0.5 * geometry.resolution).max(0.0);
          nearest = std::min(nearest, gap.matrix().norm());
        }
      }
      const bool inside = geometry.contains(geometry.cellAt(center));
      const auto found = world.nearestObstacle(center, radius);
      const double distance = found ? (*found - center).norm() : radius;
      EXPECT_NEAR(distance, inside ? nearest : 0.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace omega_slam::simulation

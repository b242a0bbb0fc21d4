#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "omega_slam/grid/distance_field.h"
#include "support/seeds.h"

namespace omega_slam::grid {
namespace {

struct Obstacles {
  GridGeometry geometry;
  std::vector<std::uint8_t> flags;
};

Obstacles randomObstacles(std::mt19937_64& random) {
  std::uniform_int_distribution<int> size(1, 24);
  std::uniform_real_distribution<double> place(-20.0, 20.0);
  std::uniform_real_distribution<double> density(0.0, 0.3);
  Obstacles result{{0.05, {place(random), place(random)}, size(random), size(random)}, {}};
  std::bernoulli_distribution flag(density(random));
  for (std::size_t i = 0; i < result.geometry.size(); ++i) {
    result.flags.push_back(flag(random) ? 1 : 0);
  }
  return result;
}

/// Looks at every square, and at a rim of them around the grid.
double bruteForce(const DistanceField& field, const Eigen::Vector2d& point) {
  const GridGeometry& geometry = field.geometry();
  double least = std::numeric_limits<double>::infinity();
  for (int row = -2; row < geometry.height + 2; ++row) {
    for (int column = -2; column < geometry.width + 2; ++column) {
      if (field.isObstacle({column, row})) {
        const Eigen::Vector2d half(0.5 * geometry.resolution, 0.5 * geometry.resolution);
        const Eigen::Vector2d away = (point - geometry.center({column, row})).cwiseAbs() - half;
        least = std::min(least, away.cwiseMax(0.0).norm());
      }
    }
  }
  return least;
}

class DistanceFieldProperty : public testing::TestWithParam<Outside> {};

TEST_P(DistanceFieldProperty, IsWhatLookingAtEverySquareGives) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int trial = 0; trial < 30; ++trial) {
      const Obstacles obstacles = randomObstacles(random);
      const DistanceField field(obstacles.geometry, obstacles.flags, GetParam());
      for (int row = 0; row < obstacles.geometry.height; ++row) {
        for (int column = 0; column < obstacles.geometry.width; ++column) {
          const Cell cell(column, row);
          const double expected = bruteForce(field, obstacles.geometry.center(cell));
          if (std::isinf(expected)) {
            ASSERT_TRUE(std::isinf(field.atCell(cell)));
          } else {
            ASSERT_NEAR(field.atCell(cell), expected, 1e-6);
          }
        }
      }
    }
  }
}

TEST_P(DistanceFieldProperty, AnswersForPointsAgreeWithTheSquares) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int trial = 0; trial < 30; ++trial) {
      const Obstacles obstacles = randomObstacles(random);
      const GridGeometry& geometry = obstacles.geometry;
      const DistanceField field(geometry, obstacles.flags, GetParam());
      std::uniform_real_distribution<double> share(0.0, 1.0);
      std::uniform_real_distribution<double> radius(0.01, 0.5);
      for (int i = 0; i < 50; ++i) {
        const Eigen::Vector2d size(geometry.width, geometry.height);
        const Eigen::Vector2d at(share(random), share(random));
        const Eigen::Vector2d point = geometry.origin + geometry.resolution * size.cwiseProduct(at);
        const double expected = bruteForce(field, point);
        if (std::isinf(expected)) {
          ASSERT_EQ(field.lowerBound(point), expected);
          ASSERT_EQ(field.interpolated(point), expected);
          continue;
        }
        EXPECT_LE(field.lowerBound(point), expected + 1e-6);
        EXPECT_GE(field.lowerBound(point), expected - 1.4143 * geometry.resolution);
        const double most = expected > 3.0 * geometry.resolution ? 0.1 : 0.5;
        EXPECT_LE(field.interpolated(point), expected + most * geometry.resolution);
        EXPECT_GE(field.interpolated(point), expected - 1.4143 * geometry.resolution);
        const double r = radius(random);
        if (std::abs(expected - r) > 1e-6) {
          EXPECT_EQ(field.isClear(point, r), expected > r) << "radius " << r;
        }
      }
    }
  }
}

TEST(DistanceField, KnowsHowFarItIsFromOutside) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int trial = 0; trial < 30; ++trial) {
      const Obstacles obstacles = randomObstacles(random);
      const GridGeometry& geometry = obstacles.geometry;
      const DistanceField field(geometry, obstacles.flags, Outside::kOpen);
      std::uniform_real_distribution<double> share(-3.0, 4.0);
      const Eigen::Vector2d size(geometry.width, geometry.height);
      for (int i = 0; i < 50; ++i) {
        const Eigen::Vector2d in_grid = size.cwiseProduct(Eigen::Vector2d(share(random), 2.0));
        const Eigen::Vector2d point = geometry.origin + geometry.resolution * in_grid;
        const double expected = bruteForce(field, point);
        if (std::isinf(expected)) {
          ASSERT_EQ(field.lowerBound(point), expected);
          continue;
        }
        EXPECT_LE(field.lowerBound(point), expected + 1e-6);
        EXPECT_GE(field.lowerBound(point), geometry.resolution * geometry.height - 1e-6);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Edges, DistanceFieldProperty,
                         testing::Values(Outside::kOpen, Outside::kObstacle),
                         [](const auto& instance) {
                           return instance.param == Outside::kOpen ? "Open" : "Obstacle";
                         });

TEST(DistanceField, RefusesFlagsThatDoNotFitTheGrid) {
  EXPECT_THROW(DistanceField({0.05, {0.0, 0.0}, 3, 3}, {0, 1}, Outside::kOpen),
               std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::grid

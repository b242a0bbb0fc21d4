#include "omega_slam/matching/point_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

double nearestByBruteForce(const Points& points, const Eigen::Vector2d& query) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& point : points) {
    smallest = std::min(smallest, (point - query).squaredNorm());
  }
  return smallest;
}

void compareWithBruteForce(const Points& points, const Eigen::Vector2d& query, double reach) {
  const PointIndex index(points);
  const double expected = nearestByBruteForce(points, query);
  const auto nearest = index.nearest(query, reach);
  ASSERT_EQ(nearest.has_value(), expected <= reach * reach)
      << query.transpose() << " reach " << reach;
  if (nearest) {
    EXPECT_EQ(nearest->squared_distance, expected);
    EXPECT_EQ((points[nearest->index] - query).squaredNorm(), expected);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_TRUE(i == nearest->index ||
                  (points[i] - query).squaredNorm() >= nearest->squared_next * (1.0 - 1e-9));
    }
  }
  std::vector<PointIndex::Neighbour> found;
  index.within(query, reach, found);
  std::vector<std::size_t> indices;
  for (const auto& neighbour : found) {
    EXPECT_EQ((points[neighbour.index] - query).squaredNorm(), neighbour.squared_distance);
    EXPECT_LE(neighbour.squared_distance, reach * reach);
    indices.push_back(neighbour.index);
  }
  std::sort(indices.begin(), indices.end());
  EXPECT_EQ(std::unique(indices.begin(), indices.end()), indices.end()) << "found twice";
  EXPECT_EQ(found.size(), static_cast<std::size_t>(
                              std::count_if(points.begin(), points.end(), [&](const auto& point) {
                                return (point - query).squaredNorm() <= reach * reach;
                              })));
}

TEST(PointIndexLaws, AgreesWithBruteForce) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    // Rooms smaller and larger than the width after which the grid begins anew.
    for (const double spread : {0.3, 3.0, 30.0}) {
      std::normal_distribution<double> normal(0.0, spread);
      for (const std::size_t size : {1U, 2U, 5U, 300U}) {
        Points points(size);
        for (auto& point : points) {
          point = {normal(random), normal(random)};
        }
        for (int i = 0; i < 30; ++i) {
          const Eigen::Vector2d query(normal(random), normal(random));
          compareWithBruteForce(points, query, std::abs(normal(random)));
        }
        compareWithBruteForce(points, points.front(), 0.0);
      }
    }
  }
}

TEST(PointIndexLaws, PointsOnTheBordersOfCells) {
  Points points;
  for (int x = -4; x <= 4; ++x) {
    for (int y = -4; y <= 4; ++y) {
      points.emplace_back(0.1 * x, 0.1 * y);
    }
  }
  for (const auto& point : points) {
    for (const double reach : {0.0, 0.05, 0.1, 0.3}) {
      compareWithBruteForce(points, point, reach);
      compareWithBruteForce(points, point + Eigen::Vector2d(0.05, 0.02), reach);
    }
  }
}

TEST(PointIndexLaws, FarFromTheOrigin) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal(0.0, 1.0);
  for (const double distance : {-1e3, 1e5, -1e9, 1e15}) {
    Points points;
    for (int i = 0; i < 50; ++i) {
      points.emplace_back(distance + normal(random), normal(random));
    }
    for (int i = 0; i < 20; ++i) {
      compareWithBruteForce(points, {distance + normal(random), normal(random)}, 0.4);
    }
    compareWithBruteForce(points, {0.0, 0.0}, 1.0);
    compareWithBruteForce(points, {0.0, 0.0}, 1e16);
  }
}

TEST(PointIndexLaws, EmptyIndexFindsNothing) {
  const Points none;
  EXPECT_FALSE(PointIndex(none).nearest({0.0, 0.0}, 1e9));
  std::vector<PointIndex::Neighbour> found(3);
  PointIndex(none).within({0.0, 0.0}, 1.0, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace omega_slam::matching

#include "omega_slam/matching/point_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

TEST(PointIndexLaws, AgreesWithBruteForce) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, 3.0);
    for (const std::size_t size : {1U, 2U, 5U, 300U}) {
      Points points(size);
      for (auto& point : points) {
        point = {normal(random), normal(random)};
      }
      const PointIndex index(points);
      std::vector<PointIndex::Neighbour> found;
      for (int i = 0; i < 50; ++i) {
        const Eigen::Vector2d query(normal(random), normal(random));
        index.nearest(query, 4, found);
        std::vector<double> expected;
        for (const auto& point : points) {
          expected.push_back((point - query).squaredNorm());
        }
        std::sort(expected.begin(), expected.end());
        ASSERT_EQ(found.size(), std::min<std::size_t>(4, size));
        for (std::size_t k = 0; k < found.size(); ++k) {
          EXPECT_NEAR(found[k].squared_distance, expected[k], 1e-9);
          EXPECT_NEAR((points[found[k].index] - query).squaredNorm(), expected[k], 1e-9);
        }
        index.within(query, 1.5, found);
        EXPECT_EQ(found.size(), static_cast<std::size_t>(std::count_if(
                                    expected.begin(), expected.end(),
                                    [](double squared) { return squared < 1.5 * 1.5; })));
      }
    }
  }
}

TEST(PointIndexLaws, EmptyIndexFindsNothing) {
  const Points none;
  std::vector<PointIndex::Neighbour> found(3);
  PointIndex(none).nearest({0.0, 0.0}, 2, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace omega_slam::matching

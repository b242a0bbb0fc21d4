#include "omega_slam/matching/local_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr double kInf = std::numeric_limits<double>::infinity();
const double kNan = std::nan("");

bool isEmpty(const LocalMap& map) {
  for (const ValueGrid& grid : map.grids()) {
    for (const std::uint8_t value : grid.values) {
      if (value > 0) {
        return false;
      }
    }
  }
  return true;
}

TEST(LocalMapHostile, ViewsWithoutPointsLeaveNothing) {
  LocalMap map;
  EXPECT_TRUE(map.insert({}, {}));
  EXPECT_TRUE(isEmpty(map));
  EXPECT_TRUE(isEmpty(LocalMap({}, Reference{})));
  EXPECT_TRUE(isEmpty(LocalMap({}, Reference(3))));
}

TEST(LocalMapHostile, PointsThatAreNotFiniteAreLeftOut) {
  LocalMap map;
  EXPECT_TRUE(map.insert(
      {{{kNan, 0.0}, {0.0, kInf}, {-kInf, kNan}, {1e300, 1e300}, {1.0, 1.0}}, {0.0, 0.0}}, {}));
  EXPECT_EQ(map.recentViews().back().points.size(), 1U);
  EXPECT_FALSE(isEmpty(map));
}

TEST(LocalMapHostile, LaserNowhereSeesNothing) {
  LocalMap map;
  const View view{{{1.0, 1.0}}, {0.0, 0.0}};
  EXPECT_FALSE(map.insert(view, {kNan, 0.0, 0.0}));
  EXPECT_FALSE(map.insert(view, {0.0, 0.0, kInf}));
  EXPECT_FALSE(map.insert(view, {1e300, 0.0, 0.0}));
  EXPECT_FALSE(map.insert({{{1.0, 1.0}}, {0.0, kNan}}, {}));
  EXPECT_TRUE(map.recentViews().empty());
  const LocalMap none({}, {{{{1.0, 1.0}}, {kInf, 0.0}}});
  EXPECT_TRUE(none.recentViews().empty());
}

TEST(LocalMapHostile, FarFromTheOriginMemoryStaysBounded) {
  LocalMap map;
  for (const double far : {0.0, 9e5, -9e5, 123456.789}) {
    EXPECT_TRUE(map.insert({{{3.0, 1.0}, {-2.0, 4.0}}, {0.0, 0.0}}, {far, -far, 1.0}));
    EXPECT_LE(map.grids().front().geometry.size(), 4000U * 4000U);
    EXPECT_FALSE(isEmpty(map));
  }
}

TEST(LocalMapHostile, ReturnsOfBeamsOfNoLength) {
  LocalMap map;
  EXPECT_TRUE(map.insert({Points(50, {0.5, 0.5}), {0.5, 0.5}}, {}));
  EXPECT_FALSE(isEmpty(map)) << "a laser that touches a wall";
  EXPECT_TRUE(map.insert({{{0.5, 0.5}, {1.0, 0.5}}, {0.5, 0.5}}, {}));
}

TEST(LocalMapHostile, ManyMoreViewsThanNumbersForThem) {
  LocalMapConfig config;
  config.resolution = 0.1;
  config.levels = 2;
  LocalMap map(config);
  const View wall{{{0.55, 0.05}}, {0.0, 0.0}};
  const View elsewhere{{{-0.55, -0.05}}, {0.0, 0.0}};
  const auto value = [&map] {
    const ValueGrid& grid = map.grids().front();
    return grid.values[grid.geometry.index(grid.geometry.cellAt({0.55, 0.05}))];
  };
  ASSERT_TRUE(map.insert(wall, {}));
  const int once = value();
  for (int i = 0; i < 65534; ++i) {  // the number of the next view is that of the first
    ASSERT_TRUE(map.insert(elsewhere, {}));
  }
  EXPECT_EQ(value(), once);
  ASSERT_TRUE(map.insert(wall, {}));
  EXPECT_GT(value(), once) << "it must not be taken for the first one";
}

TEST(LocalMapHostile, SenselessConfigurationThrows) {
  LocalMapConfig config;
  config.resolution = 0.0;
  config.levels = 0;
  config.reach = kNan;
  EXPECT_EQ(config.validate().size(), 3U);
  EXPECT_THROW(LocalMap{config}, std::invalid_argument);
  config = {};
  config.reach = 1000.0;
  EXPECT_EQ(config.validate().size(), 1U) << "more cells than there is memory for";
}

}  // namespace
}  // namespace omega_slam::matching

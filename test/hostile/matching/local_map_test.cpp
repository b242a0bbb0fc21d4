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
  // What both see ends the beam of one and is on the way of the other: each must count.
  const View wall{{{0.55, 0.05}}, {0.0, 0.0}};
  const View behind{{{0.85, 0.05}}, {0.0, 0.0}};
  const auto step = [&] { return map.insert(wall, {}) && map.insert(behind, {}); };
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(step());
  }
  const auto settled = map.grids().front().values;
  for (int i = 0; i < 40000; ++i) {
    ASSERT_TRUE(step());
    ASSERT_EQ(map.grids().front().values, settled) << i;
  }
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

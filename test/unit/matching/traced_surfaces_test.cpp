#include "omega_slam/matching/traced_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace omega_slam::matching {
namespace {

/// Returns from a straight wall, `step` apart.
Points wall(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double step) {
  Points points;
  const int count = static_cast<int>(std::round((end - start).norm() / step));
  for (int i = 0; i <= count; ++i) {
    points.push_back(start + (end - start) * i / count);
  }
  return points;
}

TEST(TracedSurfacesTest, NormalsPointToWhereTheLaserStood) {
  View view{wall({1.0, -1.0}, {1.0, 1.0}, 0.05), {0.0, 0.0}};
  for (const SurfacePatch& patch : tracePatches(view)) {
    EXPECT_NEAR(patch.surface.normal.x(), -1.0, 1e-9);
  }
  view.origin = {2.0, 0.0};
  for (const SurfacePatch& patch : tracePatches(view)) {
    EXPECT_NEAR(patch.surface.normal.x(), 1.0, 1e-9);
  }
}

TEST(TracedSurfacesTest, NoiseIsSmoothedAlongAWall) {
  View view{wall({1.0, -1.0}, {1.0, 1.0}, 0.02), {0.0, 0.0}};
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    view.points[i].x() += i % 2 == 0 ? 0.02 : -0.02;
  }
  for (const SurfacePatch& patch : tracePatches(view)) {
    EXPECT_NEAR(std::abs(patch.hit.x() - 1.0), 0.02, 1e-9) << "what was measured stays";
    if (std::abs(patch.hit.y()) < 0.85) {  // half a neighbourhood, at an end, is too short a line
      EXPECT_NEAR(patch.point.x(), 1.0, 0.012);
    }
  }
}

TEST(TracedSurfacesTest, AnEdgeEndsASurface) {
  Points points = wall({2.0, -1.0}, {2.0, 0.0}, 0.05);
  const std::size_t edge = points.size() - 1;
  const Points behind = wall({2.6, 0.0}, {2.6, 1.0}, 0.05);
  points.insert(points.end(), behind.begin(), behind.end());
  const auto patches = tracePatches({points, {0.0, 0.0}});
  EXPECT_TRUE(patches[edge - 1].joins_next);
  EXPECT_FALSE(patches[edge].joins_next);
  EXPECT_NEAR(patches[edge].point.x(), 2.0, 1e-9) << "what lies behind does not bend it";
  EXPECT_NEAR(patches[edge + 1].point.x(), 2.6, 1e-9);
  EXPECT_FALSE(patches.back().joins_next);
}

TEST(TracedSurfacesTest, FarReturnsMayLieFartherApart) {
  const auto joins = [](double range, double gap) {
    return tracePatches({{{range, 0.0}, {range, gap}}, {0.0, 0.0}})[0].joins_next;
  };
  EXPECT_TRUE(joins(8.0, 0.45));
  EXPECT_FALSE(joins(2.0, 0.45));
  EXPECT_FALSE(joins(50.0, 0.6)) << "but not that far";
}

TEST(TracedSurfacesTest, AReturnOnItsOwnIsNoLine) {
  const auto patches = tracePatches({{{1.0, 0.0}, {3.0, 2.0}}, {0.0, 0.0}});
  ASSERT_EQ(patches.size(), 2U);
  EXPECT_FALSE(patches[0].surface.isLine());
  EXPECT_EQ(patches[0].point, patches[0].hit);
}

TEST(TracedSurfacesTest, SamplesFillTheGapsBetweenReturns) {
  const View view{wall({8.0, -2.0}, {8.0, 2.0}, 0.4), {0.0, 0.0}};
  const TracedSurfaces surfaces = traceSurfaces({view}, 0.04);
  for (double y = -2.0; y <= 2.0; y += 0.01) {
    const bool is_near = std::any_of(
        surfaces.samples.begin(), surfaces.samples.end(), [&](const SurfaceSample& sample) {
          return (sample.place - Eigen::Vector2d(8.0, y)).norm() < 0.05;
        });
    EXPECT_TRUE(is_near) << y;
  }
  for (const SurfaceSample& sample : surfaces.samples) {
    const SurfacePatch& patch = surfaces.patches[sample.patch];
    EXPECT_LT((patch.point - sample.place).norm(), 0.21) << "of the nearer of the two returns";
  }
}

TEST(TracedSurfacesTest, WhereViewsOverlapTheNewestIsSampled) {
  const View old{wall({1.0, -1.0}, {1.0, 1.0}, 0.05), {0.0, 0.0}};
  View fresh = old;
  for (Eigen::Vector2d& point : fresh.points) {
    point.x() += 0.003;
  }
  const TracedSurfaces surfaces = traceSurfaces({old, fresh}, 0.04);
  for (const SurfaceSample& sample : surfaces.samples) {
    EXPECT_NEAR(sample.place.x(), 1.003, 1e-9);
  }
}

TEST(TracedSurfacesTest, ThinnedPointsAreOneToASquare) {
  const Points points{{0.01, 0.01}, {0.09, 0.02}, {0.11, 0.02}, {-0.01, 0.01}};
  const Points few = thinned(points, 0.1);
  ASSERT_EQ(few.size(), 3U);
  EXPECT_EQ(few[0], points[0]);
  EXPECT_EQ(few[1], points[2]);
  EXPECT_EQ(few[2], points[3]);
  EXPECT_TRUE(thinned({}, 0.1).empty());
}

}  // namespace
}  // namespace omega_slam::matching

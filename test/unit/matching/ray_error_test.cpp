#include "omega_slam/matching/ray_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::matching {
namespace {

using geometry::kPi;

/// Part of a circle around the laser, measured by beams half a degree apart.
View arc(double radius, double first_angle, double last_angle) {
  View view;
  for (double angle = first_angle; angle < last_angle; angle += kPi / 360.0) {
    view.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return view;
}

View circle(double radius) { return arc(radius, 0.0, 2.0 * kPi); }

double errorBetween(const Reference& reference, const View& scan, double cap = 1.0) {
  return RayReference(reference, cap).squaredError(RayScan(scan), {});
}

TEST(RayError, MeanOfSquaredDifferences) {
  EXPECT_EQ(errorBetween({circle(2.0)}, circle(2.0)), 0.0);
  EXPECT_NEAR(errorBetween({circle(2.0)}, circle(2.1)), 0.01, 1e-6);
  View both = arc(2.1, 0.0, kPi);
  const View rest = arc(1.7, kPi + 0.001, 2.0 * kPi);
  both.points.insert(both.points.end(), rest.points.begin(), rest.points.end());
  EXPECT_NEAR(errorBetween({circle(2.0)}, both), 0.5 * 0.01 + 0.5 * 0.09, 1e-3);
}

TEST(RayError, DifferenceCountsNoMoreThanTheCap) {
  EXPECT_NEAR(errorBetween({circle(2.0)}, circle(5.0), 1.0), 1.0, 1e-6);
  EXPECT_NEAR(errorBetween({circle(2.0)}, circle(5.0), 0.3), 0.09, 1e-6);
}

TEST(RayError, RaysOfOneOnlyAreNotCompared) {
  EXPECT_EQ(errorBetween({circle(2.0)}, arc(2.0, 0.5, 1.5)), 0.0);
  EXPECT_EQ(errorBetween({arc(2.0, 0.5, 1.5)}, circle(2.0)), 0.0);
  EXPECT_NEAR(errorBetween({circle(2.0)}, arc(2.1, 0.5, 1.5)), 0.01, 1e-6);
}

TEST(RayError, WhatLacksOfTheRequiredOverlapCostsTheCap) {
  const View half = arc(2.0, 0.0, kPi);
  EXPECT_EQ(errorBetween({half}, arc(2.0, 0.25 * kPi, 1.25 * kPi), 0.5), 0.0) << "3/4 overlap";
  const double lacking = (0.7 - 0.5) / 0.7;
  EXPECT_NEAR(errorBetween({half}, arc(2.0, 0.5 * kPi, 1.5 * kPi), 0.5), lacking * 0.25, 2e-3);
  EXPECT_EQ(errorBetween({half}, arc(2.0, 1.1 * kPi, 1.9 * kPi), 0.5), 0.25) << "no overlap";
}

TEST(RayError, OnlyTheNearestReturnInADirectionIsSeen) {
  View walls = circle(2.0);
  const View hidden = circle(3.0);
  walls.points.insert(walls.points.end(), hidden.points.begin(), hidden.points.end());
  EXPECT_EQ(errorBetween({walls}, circle(2.0)), 0.0);
  EXPECT_EQ(errorBetween({circle(2.0)}, walls), 0.0);
}

TEST(RayError, OlderViewsCountOnlyWhereTheNewestSeesNothing) {
  const Reference reference{circle(1.8), circle(1.5), arc(2.0, 0.0, kPi)};
  EXPECT_NEAR(errorBetween(reference, arc(2.0, 0.1, kPi - 0.1)), 0.0, 1e-9)
      << "although older views have seen something nearer";
  EXPECT_NEAR(errorBetween(reference, arc(2.0, kPi + 0.1, 2.0 * kPi - 0.1)), 0.25, 1e-6)
      << "to the nearest of the older views";
}

TEST(RayError, RaysBeginAtTheOriginOfTheNewestView) {
  View elsewhere = transformed({3.0, -1.0, 0.4}, circle(2.0));
  EXPECT_NEAR(RayReference({elsewhere}).squaredError(RayScan(circle(2.1)), {3.0, -1.0, 0.0}), 0.01,
              1e-4);
}

TEST(RayError, EdgesAreNotJoined) {
  EXPECT_EQ(RayScan({{{2.0, 0.0}, {1.5, 0.1}}}).rays(), 2.0) << "a near thing before a far one";
  EXPECT_NEAR(RayScan({{{2.0, 0.0}, {2.0, 0.1}}}).rays(), 0.05 / (2.0 * kPi) * kRayDirections, 1.0)
      << "a wall between two beams";
}

TEST(RayError, LonePointsLieInTheNearestDirection) {
  const double step = 2.0 * kPi / kRayDirections;
  const RayReference reference(Reference{arc(2.0, 0.0, 16.2 * step)});
  const auto error = [&](double steps) {
    return reference.squaredError(RayScan({{{2.0, 0.0}}}), {0.0, 0.0, steps * step});
  };
  EXPECT_NEAR(error(14.6), 0.0, 1e-9);
  EXPECT_NEAR(error(0.6), 0.0, 1e-9);
  EXPECT_EQ(error(16.6), 1.0) << "beyond the end of the wall";
}

TEST(RayError, LinesAcrossTheFirstDirectionAreWhole) {
  const Eigen::Vector2d left(2.0, 0.08);
  const Eigen::Vector2d right(2.0, -0.08);
  const double expected = 0.08 / (2.0 * kPi) * kRayDirections;
  EXPECT_NEAR(RayScan({{right, left}}).rays(), expected, 1.0);
  EXPECT_NEAR(RayScan({{left, right}}).rays(), expected, 1.0);
}

TEST(RayError, LinesThatPassByTheLaserAreNotSeen) {
  EXPECT_EQ(RayScan({{{0.02, 0.01}, {-0.02, 0.01}}}).rays(), 0.0);
}

TEST(RayError, SweepsMayGoEitherWay) {
  View wall;
  for (double y = -1.0; y <= 1.0; y += 0.1) {
    wall.points.emplace_back(1.5 + 0.5 * y, y);
  }
  const double forth = errorBetween({circle(2.0)}, wall);
  std::reverse(wall.points.begin(), wall.points.end());
  EXPECT_NEAR(errorBetween({circle(2.0)}, wall), forth, 1e-6);
  EXPECT_GT(forth, 0.1);
}

TEST(RayError, FewPointsOfAWallAreAsGoodAsAll) {
  const View scan = circle(2.0);
  const RayScan few(scan, 100);
  EXPECT_LT(few.vertices().size(), 110U);
  EXPECT_EQ(RayScan(scan).vertices().size(), scan.points.size());
  EXPECT_LT(RayReference({scan}).squaredError(few, {}), 1e-6);
  EXPECT_GT(few.rays(), 0.99 * RayScan(scan).rays());
}

}  // namespace
}  // namespace omega_slam::matching

#include "omega_slam/matching/ray_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/room.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

View room() {
  std::mt19937_64 random(1);
  return {test::measurePoints(test::furnishedRoom(), {}, 180, 0.01, random)};
}

TEST(RayErrorHostile, NothingToCompareIsTheLargestError) {
  const View empty;
  for (const Reference& reference : {Reference{}, Reference{empty}, Reference{room()}}) {
    EXPECT_EQ(RayReference(reference).squaredError(RayScan(empty), {}), 1.0);
  }
  EXPECT_EQ(RayReference({empty}).squaredError(RayScan(room()), {}), 1.0);
}

TEST(RayErrorHostile, OnlyTheNewestViewIsEmpty) {
  EXPECT_LT(RayReference({room(), View{}}).squaredError(RayScan(room()), {}), 1e-6);
}

TEST(RayErrorHostile, OneBeam) {
  const View beam{{{2.0, 0.0}}};
  const RayReference reference(Reference{beam});
  EXPECT_EQ(reference.squaredError(RayScan(beam), {}), 0.0);
  EXPECT_NEAR(reference.squaredError(RayScan(beam), {0.1, 0.0, 0.0}), 0.01, 1e-6);
  EXPECT_EQ(reference.squaredError(RayScan(beam), {0.0, 0.0, 1.0}), 1.0);
}

TEST(RayErrorHostile, PointsAtTheOriginAndInOnePlace) {
  const View at_origin{Points(100, {0.0, 0.0})};
  const View heap{Points(100, {1.0, 1.0})};
  for (const View& a : {at_origin, heap, room()}) {
    for (const View& b : {at_origin, heap, room()}) {
      const double error = RayReference({a}).squaredError(RayScan(b), {0.3, 0.0, 0.1});
      EXPECT_GE(error, 0.0);
      EXPECT_LE(error, 1.0);
    }
  }
}

TEST(RayErrorHostile, PosesThatAreNotFiniteSeeNothing) {
  const RayReference reference(Reference{room()});
  for (const double odd : {static_cast<double>(NAN), kInfinity, -kInfinity}) {
    for (const Pose2& pose : {Pose2{odd, 0.0, 0.0}, Pose2{0.0, 0.0, odd}}) {
      EXPECT_EQ(reference.squaredError(RayScan(room()), pose), 1.0);
    }
  }
}

TEST(RayErrorHostile, PointsThatAreNotFiniteAreLeftOut) {
  View odd = room();
  for (std::size_t i = 0; i < odd.points.size(); i += 7) {
    odd.points[i].x() = i % 2 == 0 ? static_cast<double>(NAN) : kInfinity;
  }
  odd.points.front() = room().points.front();
  EXPECT_LT(RayReference({odd}).squaredError(RayScan(room()), {}), 1e-2);
  EXPECT_LT(RayReference({room()}).squaredError(RayScan(odd), {}), 1e-2);
  odd.points.front() = {NAN, NAN};
  const double error = RayReference({odd}).squaredError(RayScan(room()), {});
  EXPECT_TRUE(error >= 0.0 && error <= 1.0) << error;
}

TEST(RayErrorHostile, HugeCoordinates) {
  const Pose2 far{1e6, -1e6, 0.5};
  EXPECT_LT(RayReference({transformed(far, room())}).squaredError(RayScan(room()), far), 1e-6);
  EXPECT_EQ(RayReference({room()}).squaredError(RayScan(room()), {1e300, -1e300, 0.0}), 1.0);
  const View huge{{{1e300, 0.0}, {1e300, 1e300}, {-1e308, 1e308}}};
  EXPECT_EQ(RayReference({huge}).squaredError(RayScan(room()), {}), 1.0);
  EXPECT_EQ(RayReference({room()}).squaredError(RayScan(huge), {}), 1.0);
}

}  // namespace
}  // namespace omega_slam::matching

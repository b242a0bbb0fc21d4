#include "experiments/places.h"

#include <gtest/gtest.h>

#include <cmath>

#include "experiments/scan_trial.h"
#include "omega_slam/geometry/angle.h"
#include "support/paths.h"

namespace omega_slam::experiments {
namespace {

using geometry::Pose2;

Arena lab() { return loadArena("lab", test::sourceFolder() / "maps/lab.yaml"); }

/// 4 x 4 m of floor, but the left half is unknown.
Arena halfKnown() {
  const grid::GridGeometry geometry{0.1, {0.0, 0.0}, 40, 40};
  Arena arena{"half",
              simulation::World(geometry, std::vector<simulation::Material>(geometry.size())),
              grid::makeGrid(geometry, grid::kFree)};
  for (int row = 0; row < geometry.height; ++row) {
    for (int column = 0; column < geometry.width / 2; ++column) {
      arena.map.at({column, row}) = grid::kUnknown;
    }
  }
  return arena;
}

TEST(FreePoses, StandOnKnownFreeFloor) {
  const Arena arena = halfKnown();
  std::mt19937_64 random(1);
  const double radius = simulation::KobukiConfig{}.radius;
  bool leftmost = false;
  for (int i = 0; i < 500; ++i) {
    const Pose2 pose = drawFreePose(arena, random);
    EXPECT_GT(pose.x, 2.0 + radius - 0.1) << "a cell may stick out by less than its edge";
    EXPECT_LT(pose.x, 4.0 - radius);
    leftmost = leftmost || pose.x < 2.4;
  }
  EXPECT_TRUE(leftmost) << "all of the free floor is drawn from";
}

TEST(FreePoses, WhereNothingIsFreeThereIsNone) {
  Arena arena = halfKnown();
  arena.map = grid::makeGrid(arena.map.geometry, grid::kUnknown);
  std::mt19937_64 random(1);
  EXPECT_THROW((void)drawFreePose(arena, random), std::runtime_error);
}

TEST(FreePoses, AreTheSameForTheSameSeed) {
  const Arena arena = lab();
  const auto places = drawPlaces(arena, 5, 1);
  const auto more = drawPlaces(arena, 7, 1);
  const auto others = drawPlaces(arena, 5, 2);
  for (std::size_t k = 0; k < places.size(); ++k) {
    EXPECT_EQ(places[k].vector(), more[k].vector()) << "whatever the number";
    EXPECT_NE(places[k].vector(), others[k].vector());
  }
}

TEST(Scans, OfOnePlaceDifferByTheNoiseOfTheirRanges) {
  const Arena arena = lab();
  const Pose2 place = drawPlaces(arena, 1, 1).front();
  const matching::View perfect = takePerfectScan(arena, place);
  std::mt19937_64 random(3);
  const TwoScans scans = takeTwoScans(arena, place, random);
  ASSERT_GT(perfect.points.size(), 300U);
  ASSERT_EQ(perfect.points.size(), takePerfectScan(arena, place).points.size());
  EXPECT_EQ(perfect.points, takePerfectScan(arena, place).points);
  EXPECT_NE(scans.reference.points, scans.scan.points);
  // Beams near the range's end return in one scan and not in the other: no pairs by index.
  double squares = 0.0;
  std::size_t paired = 0;
  for (const Eigen::Vector2d& point : scans.scan.points) {
    const Eigen::Vector2d beam = point - perfect.origin;
    for (const Eigen::Vector2d& candidate : perfect.points) {
      const Eigen::Vector2d other = candidate - perfect.origin;
      const double cross = beam.x() * other.y() - beam.y() * other.x();
      if (std::abs(cross) < 1e-6 && beam.dot(other) > 0.0) {
        squares += std::pow((beam.norm() - other.norm()) / rangeDeviation(other.norm()), 2);
        ++paired;
      }
    }
  }
  ASSERT_GT(paired, 300U);
  EXPECT_NEAR(squares / static_cast<double>(paired), 1.0, 0.2);
}

TEST(Odometry, ErrsByTheLevel) {
  std::mt19937_64 random(1);
  int left = 0;
  for (int i = 0; i < 100; ++i) {
    const Pose2 moved = drawOdometry(OdometryNoise::kTranslation, 0.7, random);
    EXPECT_NEAR(moved.translation().norm(), 0.7, 1e-12);
    EXPECT_EQ(moved.theta, 0.0);
    const Pose2 turned = drawOdometry(OdometryNoise::kRotation, 0.7, random);
    EXPECT_EQ(turned.translation().norm(), 0.0);
    EXPECT_NEAR(std::abs(turned.theta), 0.7, 1e-12);
    left += turned.theta > 0.0 ? 1 : 0;
  }
  EXPECT_GT(left, 25);
  EXPECT_LT(left, 75);
}

}  // namespace
}  // namespace omega_slam::experiments

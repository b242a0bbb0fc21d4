#include "omega_slam/matching/ray_sharpening.h"

#include <gtest/gtest.h>

#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

/// A corridor along x with a cupboard on each side, which have short fronts.
test::Room corridorWithCupboards() {
  test::Room room = test::endlessCorridor();
  room.addBox({1.0, 0.75}, {1.3, 1.0});
  room.addBox({-1.9, -1.0}, {-1.6, -0.75});
  return room;
}

View see(const test::Room& room, std::mt19937_64& random) {
  return {test::measurePoints(room, {}, 720, 0.01, random), {0.0, 0.0}};
}

/// A match that points have led to, which knows nothing of x.
MatchResult openAlongX(double off) {
  MatchResult found;
  found.T_reference_scan = {off, 0.0, 0.0};
  found.covariance = Eigen::Vector3d(1.0, 1e-4, 1e-5).asDiagonal();
  return found;
}

TEST(RaySharpeningLaws, CupboardsTellWhereAlongTheCorridor) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const View reference = see(corridorWithCupboards(), random);
    const View scan = see(corridorWithCupboards(), random);
    for (const double off : {-0.25, -0.1, 0.0, 0.1, 0.25}) {
      const auto sharp = sharpenByRays({reference}, scan, openAlongX(off), {});
      ASSERT_TRUE(sharp) << off;
      EXPECT_NEAR(sharp->x, 0.0, 0.03) << off;
      EXPECT_EQ(sharp->y, 0.0) << off;
      EXPECT_EQ(sharp->theta, 0.0) << off;
    }
  }
}

TEST(RaySharpeningLaws, BareCorridorTellsNothing) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const View reference = see(test::endlessCorridor(), random);
    const View scan = see(test::endlessCorridor(), random);
    EXPECT_FALSE(sharpenByRays({reference}, scan, openAlongX(0.2), {}));
  }
}

TEST(RaySharpeningLaws, WhatIsKnownIsLeftAlone) {
  std::mt19937_64 random(1);
  const View view = see(corridorWithCupboards(), random);
  MatchResult found = openAlongX(0.05);
  found.covariance = Eigen::Vector3d(3e-4, 1e-4, 1e-5).asDiagonal();
  EXPECT_FALSE(sharpenByRays({view}, view, found, {}));
}

TEST(RaySharpeningLaws, FiniteWhateverItIsGiven) {
  std::mt19937_64 random(1);
  const View view = see(corridorWithCupboards(), random);
  const View far{{{1e9, 1e9}, {1e9, -1e9}}, {0.0, 0.0}};
  for (const View& reference : {View{}, far, view}) {
    for (const View& scan : {View{}, far, view}) {
      const auto sharp = sharpenByRays({reference}, scan, openAlongX(0.1), {});
      EXPECT_TRUE(!sharp || sharp->isFinite());
    }
  }
  EXPECT_FALSE(sharpenByRays({}, view, openAlongX(0.1), {}));
}

}  // namespace
}  // namespace omega_slam::matching

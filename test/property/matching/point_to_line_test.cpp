#include "omega_slam/matching/point_to_line.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

TEST(PointToLineLaws, ReachesTheTruthThatPointsAloneMiss) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
      const Pose2 place = test::randomPose(0.8, 3.1, random);
      const Points reference = test::measurePoints(test::furnishedRoom(), place, 360, 0.0, random);
      const Pose2 truth = test::randomPose(0.3, 0.3, random);
      Points scan;
      for (const auto& p : reference) {
        scan.push_back(truth.inverse() * p);
      }
      SurfaceModel model(reference);
      const Pose2 guess = truth * test::randomPose(0.03, 0.015, random);
      const auto gap = test::gapBetween(refinePointToLine(model, scan, guess, {}), truth);
      EXPECT_LT(gap.translation, 2e-3) << i;
      EXPECT_LT(gap.rotation, 1e-3) << i;
    }
  }
}

TEST(PointToLineLaws, CorridorKeepsTheGuessAlongIt) {
  std::mt19937_64 random(3);
  const Points reference = test::measurePoints(test::endlessCorridor(), {}, 360, 0.0, random);
  SurfaceModel model(reference);
  const Pose2 found = refinePointToLine(model, reference, {0.07, 0.05, 0.01}, {});
  EXPECT_NEAR(found.x, 0.07, 0.01);
  EXPECT_NEAR(found.y, 0.0, 1e-3);
  EXPECT_NEAR(found.theta, 0.0, 1e-3);
}

TEST(PointToLineLaws, WithNothingInReachTheGuessStands) {
  std::mt19937_64 random(3);
  const Points room = test::measurePoints(test::furnishedRoom(), {}, 90, 0.0, random);
  SurfaceModel model(room);
  const Pose2 far{30.0, 1.0, 0.5};
  EXPECT_LT(test::gapBetween(refinePointToLine(model, room, far, {}), far).translation, 1e-9);
  const Points none;
  SurfaceModel empty(none);
  EXPECT_LT(test::gapBetween(refinePointToLine(empty, room, far, {}), far).translation, 1e-9);
}

}  // namespace
}  // namespace omega_slam::matching

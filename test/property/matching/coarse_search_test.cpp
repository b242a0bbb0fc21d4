#include "omega_slam/matching/coarse_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

TEST(CoarseSearchLaws, FindsThePlaceFromAnywhereInTheWindow) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 10; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.3, 0.5, random);
      const Points reference = test::measurePoints(test::furnishedRoom(), first, 360, 0.01, random);
      const Points scan =
          test::measurePoints(test::furnishedRoom(), first * truth, 360, 0.01, random);
      Pose2 guess = truth;
      const Pose2 error = test::randomPose(0.9, 0.28, random);
      guess = Pose2::fromVector(truth.vector() + error.vector());
      const auto gap = test::gapBetween(searchCoarsely(reference, scan, guess, {}), truth);
      EXPECT_LT(gap.translation, 0.15) << i;
      EXPECT_LT(gap.rotation, 0.06) << i;
    }
  }
}

TEST(CoarseSearchLaws, CorridorDoesNotLeadAstray) {
  std::mt19937_64 random(2);
  Points reference;  // of several keyframes, as loops are matched with
  for (const double x : {-1.5, -0.9, -0.3, 0.3, 0.9, 1.5}) {
    for (const auto& p :
         test::measurePoints(test::endlessCorridor(), {x, 0.0, 0.0}, 360, 0.01, random)) {
      reference.push_back(Pose2{x, 0.0, 0.0} * p);
    }
  }
  const Points scan =
      test::measurePoints(test::endlessCorridor(), {0.4, 0.0, 0.0}, 360, 0.01, random);
  const Pose2 guess{0.4, 0.3, 0.1};
  const Pose2 found = searchCoarsely(reference, scan, guess, {});
  EXPECT_NEAR(found.x, guess.x, 0.25) << "nothing says where along the corridor";
  EXPECT_NEAR(found.y, 0.0, 0.11);
}

TEST(CoarseSearchLaws, WithoutOverlapTheGuessStands) {
  std::mt19937_64 random(2);
  const Points room = test::measurePoints(test::furnishedRoom(), {}, 90, 0.01, random);
  const Pose2 far{40.0, 0.0, 0.0};
  EXPECT_EQ(searchCoarsely(room, room, far, {}).x, far.x);
  EXPECT_EQ(searchCoarsely({}, room, {1.0, 2.0, 0.5}, {}).y, 2.0);
  EXPECT_EQ(searchCoarsely(room, {}, {1.0, 2.0, 0.5}, {}).y, 2.0);
}

}  // namespace
}  // namespace omega_slam::matching

#include "omega_slam/slam/lost_judge.h"

#include <gtest/gtest.h>

namespace omega_slam::slam {
namespace {

constexpr double kLostDistance = 1.0;

TrackedScan contradicted() {
  TrackedScan scan;
  scan.is_contradicted = true;
  return scan;
}

TrackedScan trusted(double confidence) {
  TrackedScan scan;
  scan.is_trusted = true;
  scan.match.confidence = confidence;
  return scan;
}

TEST(LostJudge, ARobotIsLostOnceAllIsContradictedForSomeDistance) {
  LostJudge judge(kLostDistance);
  for (int i = 0; i < 9; ++i) {
    judge.note(contradicted(), {0.1, 0.0, 0.0}, 0.1);
    EXPECT_FALSE(judge.isLost()) << i;
  }
  judge.note(contradicted(), {0.0, 0.11, 0.0}, 0.1);
  EXPECT_TRUE(judge.isLost());
}

TEST(LostJudge, OneThatIsBelievedInBetweenIsNot) {
  LostJudge judge(kLostDistance);
  for (int i = 0; i < 30; ++i) {
    judge.note(i % 5 == 4 ? trusted(0.6) : contradicted(), {0.1, 0.0, 0.0}, 0.1);
  }
  EXPECT_FALSE(judge.isLost());
}

TEST(LostJudge, WhatIsNewIsNoReasonToBeLost) {
  LostJudge judge(kLostDistance);
  for (int i = 0; i < 100; ++i) {
    judge.note({}, {0.1, 0.0, 0.0}, 0.1);  // fits nowhere, contradicts nothing
  }
  EXPECT_FALSE(judge.isLost());
}

TEST(LostJudge, ARobotThatStandsIsLostAfterAWhile) {
  LostJudge judge(kLostDistance);
  judge.note(contradicted(), {}, 60.0);  // after a pause, during which nothing was seen
  EXPECT_FALSE(judge.isLost());
  for (int i = 0; i < 50; ++i) {
    judge.note(contradicted(), {}, 0.1);
  }
  EXPECT_TRUE(judge.isLost());
}

TEST(LostJudge, WhoIsLostIsFoundByASureMatchAlone) {
  LostJudge judge(kLostDistance);
  judge.note(contradicted(), {2.0, 0.0, 0.0}, 0.1);
  ASSERT_TRUE(judge.isLost());
  judge.note(trusted(0.6), {}, 0.1);
  EXPECT_TRUE(judge.isLost());
  judge.note(trusted(0.9), {}, 0.1);
  EXPECT_FALSE(judge.isLost());
}

}  // namespace
}  // namespace omega_slam::slam

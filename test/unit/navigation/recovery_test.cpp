#include "omega_slam/navigation/recovery.h"

#include <gtest/gtest.h>

namespace omega_slam::navigation {
namespace {

TEST(Recovery, GoesThroughItsStagesAndGivesUp) {
  Recovery recovery(RecoveryConfig{});
  for (int round = 0; round < RecoveryConfig{}.rounds; ++round) {
    for (const RecoveryStage stage : {RecoveryStage::kWait, RecoveryStage::kClear,
                                      RecoveryStage::kBackOff, RecoveryStage::kTurn}) {
      recovery.next(0.0, {});
      EXPECT_EQ(recovery.stage(), stage) << nameOf(recovery.stage());
    }
  }
  recovery.next(0.0, {});
  EXPECT_EQ(recovery.stage(), RecoveryStage::kGiveUp);
  recovery.reset();
  recovery.next(0.0, {});
  EXPECT_EQ(recovery.stage(), RecoveryStage::kWait);
}

TEST(Recovery, StagesEndByTimeWayOrTurn) {
  Recovery recovery(RecoveryConfig{});
  recovery.next(10.0, {});
  EXPECT_FALSE(recovery.isOver(12.9, {}, 0.0));
  EXPECT_TRUE(recovery.isOver(13.0, {}, 0.0));
  recovery.next(13.0, {});
  EXPECT_TRUE(recovery.isOver(13.0, {}, 0.0));  // to clear takes no time
  recovery.next(13.0, {});
  EXPECT_FALSE(recovery.isOver(14.0, {-0.2, 0.0, 0.0}, 0.0));
  EXPECT_TRUE(recovery.isOver(14.0, {-0.3, 0.0, 0.0}, 0.0));
  EXPECT_TRUE(recovery.isOver(19.0, {}, 0.0));  // it does not get away
  recovery.next(20.0, {});
  EXPECT_FALSE(recovery.isOver(23.0, {}, 6.0));
  EXPECT_TRUE(recovery.isOver(23.0, {}, 6.3));
}

TEST(Recovery, GivesUpAfterOneContactTooMany) {
  Recovery recovery(RecoveryConfig{});
  recovery.backOff(0.0, {});
  EXPECT_EQ(recovery.stage(), RecoveryStage::kBackOff);
  recovery.backOff(1.0, {});
  recovery.backOff(2.0, {});
  EXPECT_EQ(recovery.stage(), RecoveryStage::kGiveUp);
}

}  // namespace
}  // namespace omega_slam::navigation

#include "nodes/common/sequence_gaps.h"

#include <gtest/gtest.h>

#include <limits>

namespace omega_slam {
namespace {

TEST(SequenceGaps, NumbersLeftOutAreMessagesLost) {
  SequenceGaps gaps;
  EXPECT_EQ(gaps.lostBefore("laser", 500), 0U) << "who comes late has lost nothing";
  EXPECT_EQ(gaps.lostBefore("laser", 501), 0U);
  EXPECT_EQ(gaps.lostBefore("laser", 504), 2U);
  EXPECT_EQ(gaps.lostBefore("laser", 505), 0U);
}

TEST(SequenceGaps, PublishersCountForThemselves) {
  SequenceGaps gaps;
  EXPECT_EQ(gaps.lostBefore("one", 1), 0U);
  EXPECT_EQ(gaps.lostBefore("another", 7), 0U);
  EXPECT_EQ(gaps.lostBefore("one", 2), 0U);
  EXPECT_EQ(gaps.lostBefore("another", 9), 1U);
}

TEST(SequenceGaps, OtherJumpsSayNothing) {
  SequenceGaps gaps;
  EXPECT_EQ(gaps.lostBefore("laser", 0), 0U);
  EXPECT_EQ(gaps.lostBefore("laser", 0), 0U) << "never numbered";
  EXPECT_EQ(gaps.lostBefore("laser", 1000000), 0U);
  EXPECT_EQ(gaps.lostBefore("laser", 3), 0U) << "started again";
  EXPECT_EQ(gaps.lostBefore("laser", 4), 0U);
}

TEST(SequenceGaps, NumbersWrapAround) {
  SequenceGaps gaps;
  EXPECT_EQ(gaps.lostBefore("laser", std::numeric_limits<std::uint32_t>::max()), 0U);
  EXPECT_EQ(gaps.lostBefore("laser", 0), 0U);
  EXPECT_EQ(gaps.lostBefore("laser", 2), 1U);
}

}  // namespace
}  // namespace omega_slam

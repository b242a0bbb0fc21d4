#include "nodes/common/run_recorder_delays.h"

#include <gtest/gtest.h>

namespace omega_slam {
namespace {

constexpr char kStep[] = "scan to keyframe";

TEST(RunDelaysTest, StampsTellWhatFollowsFromWhat) {
  RunDelays delays;
  delays.begin(kStep, 1, 100.0);
  delays.begin(kStep, 2, 100.1);
  delays.begin("other", 2, 0.0);
  delays.end(kStep, 2, 100.4);
  const auto figures = delays.summarize();
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, kStep);
  EXPECT_EQ(figures[0].count, 1U);
  EXPECT_NEAR(figures[0].max, 0.3, 1e-9);
}

TEST(RunDelaysTest, WhatWasPassedOverIsNotFinishedLater) {
  RunDelays delays;
  delays.begin(kStep, 1, 100.0);
  delays.begin(kStep, 2, 100.1);
  delays.end(kStep, 2, 100.4);
  delays.end(kStep, 1, 200.0);
  EXPECT_EQ(delays.summarize().at(0).count, 1U);
}

TEST(RunDelaysTest, TheFirstOfEqualStampsCounts) {
  RunDelays delays;
  delays.begin(kStep, 1, 100.0);
  delays.begin(kStep, 1, 105.0);
  delays.end(kStep, 1, 106.0);
  EXPECT_NEAR(delays.summarize().at(0).max, 6.0, 1e-9);
}

TEST(RunDelaysTest, AnEndWithoutABeginningIsNoDelay) {
  RunDelays delays;
  delays.end(kStep, 1, 100.0);
  EXPECT_TRUE(delays.summarize().empty());
}

}  // namespace
}  // namespace omega_slam

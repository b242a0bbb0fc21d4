#include "nodes/common/run_recorder_status.h"

#include <gtest/gtest.h>

namespace omega_slam {
namespace {

RunFigures figures() {
  RunFigures result;
  result.elapsed = 83.42;
  result.distance = 21.704;
  result.keyframes = 74;
  result.loops = 2;
  result.phase = "driving 9/14";
  return result;
}

TEST(RunStatusTest, TheLineHoldsEveryFigure) {
  RunFigures known = figures();
  known.share_seen = 0.614;
  known.pose_error = 0.0312;
  EXPECT_EQ(formatStatus(known),
            "  83.4 s    21.70 m    74 keyframes    2 loops   61 % seen  error 0.031 m  "
            "driving 9/14");
}

TEST(RunStatusTest, WhatIsNotKnownIsADash) {
  EXPECT_EQ(formatStatus(figures()),
            "  83.4 s    21.70 m    74 keyframes    2 loops    - seen  error -  driving 9/14");
}

TEST(StatusLineTest, ElsewhereThanOnATerminalLinesComeAtTheirPace) {
  testing::internal::CaptureStdout();
  StatusLine line(false, 5.0);
  line.show("first", 100.0);
  line.show("too soon", 104.9);
  line.show("second", 105.0);
  line.finish("last");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "first\nsecond\nlast\n");
}

TEST(StatusLineTest, OnATerminalOneLineIsRewritten) {
  testing::internal::CaptureStdout();
  StatusLine line(true, 5.0);
  line.show("first", 100.0);
  line.show("second", 100.2);
  line.finish("last");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "\rfirst\x1b[K\rsecond\x1b[K\rlast\x1b[K\n");
}

}  // namespace
}  // namespace omega_slam

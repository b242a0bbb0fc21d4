#include "omega_slam/motion/odometry_buffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace omega_slam::motion {
namespace {

TEST(OdometryBuffer, InterpolatesWithinAndAnswersNothingOutside) {
  OdometryBuffer buffer;
  EXPECT_FALSE(buffer.at(1.0));
  EXPECT_EQ(buffer.add(1.0, {0.0, 0.0, 0.0}), OdometryVerdict::kAccepted);
  EXPECT_EQ(buffer.add(2.0, {1.0, 2.0, 0.2}), OdometryVerdict::kAccepted);
  EXPECT_FALSE(buffer.at(0.999));
  EXPECT_FALSE(buffer.at(2.001));
  EXPECT_FALSE(buffer.at(std::nan("")));
  EXPECT_DOUBLE_EQ(buffer.at(1.25)->y, 0.5);
  EXPECT_DOUBLE_EQ(buffer.at(2.0)->x, 1.0);
  EXPECT_DOUBLE_EQ(buffer.at(1.0)->x, 0.0);
}

TEST(OdometryBuffer, RefusesWhatItCanNotUse) {
  OdometryBuffer buffer(30.0, 1.0);
  buffer.add(10.0, {});
  EXPECT_EQ(buffer.add(10.0, {}), OdometryVerdict::kDuplicate);
  EXPECT_EQ(buffer.add(9.5, {}), OdometryVerdict::kOutOfOrder);
  EXPECT_EQ(buffer.add(11.0, {std::nan(""), 0.0, 0.0}), OdometryVerdict::kNotFinite);
  EXPECT_EQ(buffer.add(std::numeric_limits<double>::infinity(), {}), OdometryVerdict::kNotFinite);
  EXPECT_EQ(buffer.newest(), 10.0);
}

TEST(OdometryBuffer, ClockThatJumpsBackEmptiesIt) {
  OdometryBuffer buffer(30.0, 1.0);
  buffer.add(100.0, {1.0, 0.0, 0.0});
  EXPECT_EQ(buffer.add(5.0, {2.0, 0.0, 0.0}), OdometryVerdict::kTimeJumpedBack);
  EXPECT_FALSE(buffer.covers(100.0));
  EXPECT_TRUE(buffer.covers(5.0));
}

TEST(OdometryBuffer, ForgetsBeyondTheHorizon) {
  OdometryBuffer buffer(2.0);
  for (int i = 0; i < 10; ++i) {
    buffer.add(i, {});
  }
  EXPECT_EQ(buffer.oldest(), 7.0);
  EXPECT_EQ(buffer.newest(), 9.0);
}

}  // namespace
}  // namespace omega_slam::motion

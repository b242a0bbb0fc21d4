#include "nodes/common/odometry_track.h"

#include <gtest/gtest.h>

namespace omega_slam {
namespace {

using motion::OdometryVerdict;

/// Along x at 1 m/s; the variance of x is the stamp.
motion::Prediction prediction(double stamp) {
  motion::Prediction result{stamp, {stamp, 0.0, 0.0}, Eigen::Matrix3d::Zero()};
  result.covariance(0, 0) = stamp;
  return result;
}

OdometryTrack track(int seconds) {
  OdometryTrack result;
  for (int second = 1; second <= seconds; ++second) {
    result.add(prediction(second));
  }
  return result;
}

TEST(OdometryTrack, PosesAreInterpolatedAndCovariancesNeverPromiseTooMuch) {
  const auto at = track(3).at(1.25);
  ASSERT_TRUE(at);
  EXPECT_EQ(at->stamp, 1.25);
  EXPECT_NEAR(at->T_odom_base.x, 1.25, 1e-12);
  EXPECT_EQ(at->covariance(0, 0), 2.0);
  EXPECT_EQ(track(3).at(2.0)->covariance(0, 0), 2.0);
}

TEST(OdometryTrack, OutsideOfWhatIsHeldThereIsNoAnswer) {
  const OdometryTrack three = track(3);
  EXPECT_FALSE(three.at(0.5));
  EXPECT_FALSE(three.at(3.5));
  EXPECT_TRUE(three.covers(1.0, 3.0));
  EXPECT_FALSE(three.covers(1.0, 3.1));
  EXPECT_TRUE(three.isTooOld(0.9));
  EXPECT_FALSE(three.isTooOld(3.5));
  EXPECT_FALSE(OdometryTrack().isTooOld(0.9)) << "the odometry may just be late";
  EXPECT_FALSE(OdometryTrack().newest());
  EXPECT_EQ(three.newest(), 3.0);
}

TEST(OdometryTrack, TheMotionDuringASweepIsSeenFromItsBegin) {
  OdometryTrack turning;
  turning.add({1.0, {0.0, 0.0, 1.5707963267948966}, Eigen::Matrix3d::Zero()});
  turning.add({2.0, {0.0, 2.0, 1.5707963267948966}, Eigen::Matrix3d::Zero()});
  const geometry::Pose2 motion = turning.motionDuring(1.0, 0.5);
  EXPECT_NEAR(motion.x, 1.0, 1e-12);
  EXPECT_NEAR(motion.y, 0.0, 1e-12);
  EXPECT_EQ(turning.motionDuring(1.8, 0.5).x, 0.0) << "not covered: no motion is made up";
}

TEST(OdometryTrack, TimeJumpingBackLeavesOnlyTheNewPrediction) {
  OdometryTrack jumping = track(30);
  EXPECT_EQ(jumping.add(prediction(5.0)), OdometryVerdict::kTimeJumpedBack);
  EXPECT_FALSE(jumping.at(20.0));
  ASSERT_TRUE(jumping.at(5.0));
  EXPECT_EQ(jumping.at(5.0)->covariance(0, 0), 5.0);
}

TEST(OdometryTrack, WhatTheBufferForgetsIsForgottenTogether) {
  OdometryTrack longer = track(100);
  EXPECT_FALSE(longer.at(10.5));
  EXPECT_EQ(longer.at(99.5)->covariance(0, 0), 100.0);
  EXPECT_EQ(longer.add(prediction(100.0)), OdometryVerdict::kDuplicate);
  EXPECT_EQ(longer.add(prediction(99.5)), OdometryVerdict::kOutOfOrder);
  EXPECT_EQ(longer.at(99.5)->covariance(0, 0), 100.0);
}

}  // namespace
}  // namespace omega_slam

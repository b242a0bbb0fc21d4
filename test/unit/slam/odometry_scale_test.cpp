#include "omega_slam/slam/odometry_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace omega_slam::slam {
namespace {

using geometry::Pose2;

constexpr double kStated = 0.02;  // [m], [rad] of the odometry
constexpr double kMatch = 0.005;

Eigen::Matrix3d covarianceOf(double x, double y, double theta) {
  return Eigen::Vector3d(x, y, theta).cwiseAbs2().asDiagonal();
}

/// The scale after so many ways of a robot that drives along x, whose odometry is off by `error`,
/// sideways by a share of that, and the match by what it states.
double scaleAfter(int ways, double error, const Eigen::Matrix3d& match, double sideways = 1.0) {
  OdometryScale scale;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const Eigen::Vector3d off = match.diagonal().cwiseSqrt();
  for (int i = 0; i < ways; ++i) {
    const Pose2 by_odometry{error * normal(random), sideways * error * normal(random),
                            error * normal(random)};
    const Pose2 by_match{off[0] * normal(random), off[1] * normal(random), off[2] * normal(random)};
    scale.note({by_odometry, covarianceOf(kStated, kStated, kStated)}, {by_match, match});
  }
  return scale.value();
}

TEST(OdometryScale, IsLearntFromWhatWasSeen) {
  const Eigen::Matrix3d match = covarianceOf(kMatch, kMatch, kMatch);
  // The factor that is true is the square of these; the last fifty ways tell it to a third.
  for (const double off : {0.5, 1.0, 2.0, 4.0}) {
    const double scale = scaleAfter(300, off * kStated, match);
    EXPECT_GT(scale, 0.6 * off * off);
    EXPECT_LT(scale, 1.6 * off * off);
  }
}

TEST(OdometryScale, IsLearntAlongACorridorFromTheRest) {
  const Eigen::Matrix3d match = covarianceOf(10.0, kMatch, kMatch);  // the way along is not seen
  const double scale = scaleAfter(300, 2.0 * kStated, match);
  EXPECT_GT(scale, 2.0);
  EXPECT_LT(scale, 7.0);
}

TEST(OdometryScale, WhatIsStatedOfErrorsSidewaysDoesNotCount) {
  const Eigen::Matrix3d match = covarianceOf(kMatch, kMatch, kMatch);
  const double scale = scaleAfter(300, 2.0 * kStated, match, 0.1);
  EXPECT_GT(scale, 2.4);
  EXPECT_LT(scale, 6.4);
}

TEST(OdometryScale, StaysWhereNothingIsSeen) {
  EXPECT_NEAR(scaleAfter(300, 4.0 * kStated, covarianceOf(10.0, 10.0, 10.0)), 1.0, 0.05);
}

TEST(OdometryScale, OneSlipSaysLittle) {
  OdometryScale scale;
  const Belief match{{}, covarianceOf(kMatch, kMatch, kMatch)};
  const double stated = scaleAfter(0, 0.0, match.covariance);
  scale.note({{3.0, 0.0, 1.0}, covarianceOf(kStated, kStated, kStated)}, match);
  EXPECT_LE(scale.value(), 2.02 * stated);
}

TEST(OdometryScale, StandingStillAndNonsenseTeachNothing) {
  OdometryScale scale;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Belief match{{}, covarianceOf(kMatch, kMatch, kMatch)};
  scale.note({{}, Eigen::Matrix3d::Zero()}, match);
  scale.note({{}, Eigen::Matrix3d::Zero()}, {{}, Eigen::Matrix3d::Zero()});
  scale.note({{nan, 0.0, 0.0}, covarianceOf(kStated, kStated, kStated)}, match);
  EXPECT_EQ(scale.value(), 1.0);
}

}  // namespace
}  // namespace omega_slam::slam

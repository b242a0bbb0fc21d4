#include "omega_slam/slam/weighed_odometry.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace omega_slam::slam {
namespace {

using geometry::Pose2;

constexpr double kStretch = 1.06;  // ways are longer than the odometry has them
const Eigen::Matrix3d kStated = Eigen::Vector3d(0.01, 0.01, 0.01).cwiseAbs2().asDiagonal();

Keyframe keyframeAt(graph::NodeId id, const Pose2& T_odom_base) { return {id, T_odom_base, {}}; }

/// Weighs so many ways of 0.4 m along x.
WeighedOdometry afterWays(int ways) {
  WeighedOdometry odometry(3.0, 6.3);
  for (int i = 0; i < ways; ++i) {
    odometry.weigh(keyframeAt(0, {}), keyframeAt(1, {0.4, 0.0, 0.0}), kStated, {},
                   {{kStretch * 0.4, 0.0, 0.0}, 0.01 * kStated});
  }
  return odometry;
}

graph::Constraint constraintAlong(const WeighedOdometry& odometry, double way) {
  return odometry.constraint(keyframeAt(0, {}), keyframeAt(1, {way, 0.0, 0.0}), kStated, {}, {});
}

double deviationAlong(const graph::Constraint& constraint) {
  return std::sqrt(constraint.information.inverse()(0, 0));
}

TEST(WeighedOdometry, StepsAndConstraintsAreWithoutItsFaults) {
  WeighedOdometry odometry = afterWays(200);
  EXPECT_NEAR(constraintAlong(odometry, 0.4).T_from_to.x, kStretch * 0.4, 0.002);
  odometry.begin({0.0, {}, Eigen::Matrix3d::Zero()});
  EXPECT_NEAR(odometry.stepTo({0.5, {0.2, 0.0, 0.0}, kStated}).motion.x, kStretch * 0.2, 0.001);
}

/// The faults are in a motion that is too long to be corrected, and so must its noise be.
TEST(WeighedOdometry, LongMotionsAreAsNoisyAsTheyWereBeforeItsFaultsWereKnown) {
  WeighedOdometry odometry = afterWays(200);
  const graph::Constraint far = constraintAlong(odometry, 4.0);
  EXPECT_EQ(far.T_from_to.x, 4.0);
  EXPECT_GT(deviationAlong(far), 1.5 * deviationAlong(constraintAlong(odometry, 0.4)));
  odometry.begin({0.0, {}, Eigen::Matrix3d::Zero()});
  const OdometryStep near = odometry.stepTo({0.5, {0.2, 0.0, 0.0}, kStated});
  const OdometryStep leap = odometry.stepTo({9.0, {4.2, 0.0, 0.0}, 2.0 * kStated});
  EXPECT_EQ(leap.motion.x, 4.0);
  EXPECT_GT(leap.covariance(0, 0), 1.5 * near.covariance(0, 0));
}

TEST(WeighedOdometry, NothingIsKnownWhereItJumps) {
  WeighedOdometry odometry(3.0, 6.3);
  odometry.begin({0.0, {}, Eigen::Matrix3d::Zero()});
  const OdometryStep jump = odometry.stepTo({0.2, {50.0, 0.0, 0.0}, kStated});
  EXPECT_TRUE(jump.has_jumped);
  EXPECT_EQ(jump.motion.x, 0.0);
  EXPECT_GE(jump.covariance(0, 0), 0.25);
  EXPECT_TRUE(odometry.hasJumped());
  EXPECT_FALSE(odometry.stepTo({0.4, {50.1, 0.0, 0.0}, kStated}).has_jumped);
  odometry.weigh(keyframeAt(0, {}), keyframeAt(1, {50.1, 0.0, 0.0}), kStated, {},
                 {{0.1, 0.0, 0.0}, kStated});
  odometry.anchor();
  EXPECT_FALSE(odometry.hasJumped());
  EXPECT_NEAR(deviationAlong(constraintAlong(odometry, 0.4)), std::hypot(0.01, 0.01), 1e-9);
}

}  // namespace
}  // namespace omega_slam::slam

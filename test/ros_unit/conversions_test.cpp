#include "nodes/common/conversions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "omega_slam/geometry/angle.h"

namespace omega_slam {
namespace {

using geometry::Pose2;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A turn about the x axis by `roll`, then about z by `yaw` [rad].
geometry_msgs::Quaternion quaternion(double yaw, double roll = 0.0) {
  geometry_msgs::Quaternion q;
  q.w = std::cos(yaw / 2) * std::cos(roll / 2);
  q.x = std::cos(yaw / 2) * std::sin(roll / 2);
  q.y = std::sin(yaw / 2) * std::sin(roll / 2);
  q.z = std::sin(yaw / 2) * std::cos(roll / 2);
  return q;
}

void expectSame(const Pose2& a, const Pose2& b) {
  const Pose2 difference = geometry::relativePose(a, b);
  EXPECT_NEAR(difference.x, 0.0, 1e-12);
  EXPECT_NEAR(difference.y, 0.0, 1e-12);
  EXPECT_NEAR(difference.theta, 0.0, 1e-12);
}

TEST(Conversions, PosesComeBackAsTheyWent) {
  for (const double theta : {-geometry::kPi, -3.1, -1.0, 0.0, 1e-9, 2.0, 3.14}) {
    const Pose2 pose{1.5, -2.5, theta};
    expectSame(poseFromRos(poseToRos(pose)).value(), pose);
    expectSame(poseFromRos(transformToRos(pose)).value(), pose);
    expectSame(poseFromRos(pose2ToRos(pose)).value(), pose);
  }
}

TEST(Conversions, WhatWasReadOnceIsReadAgainToTheLastBit) {
  for (int k = -500; k < 500; ++k) {
    const Pose2 first = poseFromRos(poseToRos({0.1 * k, 1.0 / 3.0, 0.0062831 * k})).value();
    const Pose2 again = poseFromRos(poseToRos(first)).value();
    EXPECT_EQ(again.x, first.x);
    EXPECT_EQ(again.y, first.y);
    EXPECT_EQ(again.theta, first.theta);
    EXPECT_EQ(poseFromRos(transformToRos(first))->theta, first.theta);
  }
}

TEST(Conversions, HeadingsAreBroughtIntoTheHalfOpenInterval) {
  omega_slam::Pose2 message;
  message.theta = 3.0 * geometry::kPi;
  EXPECT_NEAR(poseFromRos(message)->theta, -geometry::kPi, 1e-12);
}

TEST(Conversions, YawIsReadOffATiltedPoseToo) {
  geometry_msgs::Pose pose;
  pose.orientation = quaternion(0.7, 0.1);
  EXPECT_NEAR(poseFromRos(pose)->theta, 0.7, 1e-12);
}

TEST(Conversions, PosesThatAreNoneAreRefused) {
  geometry_msgs::Pose pose;
  EXPECT_FALSE(poseFromRos(pose)) << "a quaternion of zeros is no rotation";
  pose.orientation.w = 0.9;
  EXPECT_FALSE(poseFromRos(pose));
  pose.orientation.w = kNan;
  EXPECT_FALSE(poseFromRos(pose));
  pose.orientation.w = 1.0;
  EXPECT_TRUE(poseFromRos(pose));
  pose.position.y = kInfinity;
  EXPECT_FALSE(poseFromRos(pose));
  omega_slam::Pose2 planar;
  planar.theta = kNan;
  EXPECT_FALSE(poseFromRos(planar));
}

TEST(Conversions, CovariancesComeBackAsTheyWent) {
  Eigen::Matrix3d covariance;
  covariance << 4.0, 0.1, 0.2, 0.1, 5.0, 0.3, 0.2, 0.3, 6.0;
  const auto message = covarianceToRos(covariance);
  EXPECT_EQ(message[0], 4.0);
  EXPECT_EQ(message[1], 0.1);
  EXPECT_EQ(message[5], 0.2);
  EXPECT_EQ(message[7], 5.0);
  EXPECT_EQ(message[11], 0.3);
  EXPECT_EQ(message[30], 0.2);
  EXPECT_EQ(message[35], 6.0);
  EXPECT_EQ(message[14], 0.0);
  EXPECT_EQ(covarianceFromRos(message).value(), covariance);
}

TEST(Conversions, CovariancesThatAreNoneAreRefused) {
  auto message = covarianceToRos(Eigen::Matrix3d::Identity());
  message[14] = kNan;  // z: none of our business
  EXPECT_TRUE(covarianceFromRos(message));
  message[7] = -1.0;
  EXPECT_FALSE(covarianceFromRos(message));
  message[7] = 1.0;
  message[5] = kNan;
  EXPECT_FALSE(covarianceFromRos(message));
}

TEST(Conversions, TimesThatRosCantExpressBecomeTheNearestItCan) {
  EXPECT_EQ(timeToRos(12.25), ros::Time(12, 250000000));
  EXPECT_EQ(timeToRos(-1.0), ros::Time(0));
  EXPECT_EQ(timeToRos(kNan), ros::Time(0));
  EXPECT_EQ(timeToRos(1e12).sec, std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ(timeToRos(2.0 - 1e-11), ros::Time(2, 0));
}

TEST(Conversions, ScansKeepTheirFaults) {
  sensor_msgs::LaserScan message;
  message.header.stamp = ros::Time(10, 500000000);
  message.angle_min = -1.0F;
  message.angle_increment = 0.5F;
  message.time_increment = 0.25F;
  message.range_min = 0.125F;
  message.range_max = 4.0F;
  message.ranges = {1.0F, std::numeric_limits<float>::quiet_NaN(), 3.0F};
  const sensing::LaserScan scan = scanFromRos(message);
  EXPECT_EQ(scan.stamp, 10.5);
  EXPECT_EQ(scan.angle_min, -1.0);
  EXPECT_EQ(scan.angle_increment, 0.5);
  EXPECT_EQ(scan.time_increment, 0.25);
  EXPECT_EQ(scan.range_min, 0.125);
  EXPECT_EQ(scan.range_max, 4.0);
  ASSERT_EQ(scan.ranges.size(), 3U);
  EXPECT_EQ(scan.ranges[2], 3.0F);
  EXPECT_TRUE(std::isnan(scan.ranges[1]));
}

TEST(Conversions, GridsComeBackAsTheyWent) {
  grid::OccupancyGrid grid{{0.25, {-1.0, 2.5}, 3, 2}, {-1, 0, 100, 0, -1, 100}};
  const auto message = gridToRos(grid, "map", ros::Time(5));
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.header.stamp, ros::Time(5));
  EXPECT_EQ(message.info.origin.orientation.w, 1.0);
  const auto read = gridFromRos(message).value();
  EXPECT_EQ(read.geometry.resolution, 0.25);
  EXPECT_EQ(read.geometry.origin, grid.geometry.origin);
  EXPECT_EQ(read.geometry.width, 3);
  EXPECT_EQ(read.geometry.height, 2);
  EXPECT_EQ(read.cells, grid.cells);
}

TEST(Conversions, GridsThatAreNoneAreRefused) {
  const auto sound = gridToRos({{0.25, {0.0, 0.0}, 2, 1}, {0, 100}}, "map", ros::Time(5));
  const auto refuses = [&](auto spoil) {
    auto message = sound;
    spoil(message);
    return !gridFromRos(message);
  };
  EXPECT_FALSE(refuses([](auto&) {}));
  EXPECT_TRUE(refuses([](auto& m) { m.data.pop_back(); }));
  EXPECT_TRUE(refuses([](auto& m) { m.data[0] = 101; }));
  EXPECT_TRUE(refuses([](auto& m) { m.data[0] = -2; }));
  EXPECT_TRUE(refuses([](auto& m) { m.info.resolution = 0.0F; }));
  EXPECT_TRUE(refuses([](auto& m) { m.info.resolution = std::numeric_limits<float>::infinity(); }));
  EXPECT_TRUE(refuses([](auto& m) { m.info.origin.position.x = kNan; }));
  EXPECT_TRUE(refuses([](auto& m) { m.info.origin.orientation = quaternion(0.5); }));
  EXPECT_TRUE(refuses([](auto& m) { m.info.width = m.info.height = 0x80000000U; }));
}

}  // namespace
}  // namespace omega_slam

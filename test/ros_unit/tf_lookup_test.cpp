#include "nodes/common/tf_lookup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "omega_slam/geometry/angle.h"

namespace omega_slam {
namespace {

using geometry::kPi;
using ::testing::Test;

/// The laser at (0.1, 0.2), turned by `roll` about x, then by `yaw` about z [rad].
geometry_msgs::TransformStamped mount(double yaw, double roll) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "base_link";
  transform.child_frame_id = "laser";
  transform.header.stamp = ros::Time(12, 500000000);
  transform.transform.translation.x = 0.1;
  transform.transform.translation.y = 0.2;
  auto& q = transform.transform.rotation;
  q.w = std::cos(yaw / 2) * std::cos(roll / 2);
  q.x = std::cos(yaw / 2) * std::sin(roll / 2);
  q.y = std::sin(yaw / 2) * std::sin(roll / 2);
  q.z = std::sin(yaw / 2) * std::cos(roll / 2);
  return transform;
}

TEST(LaserMount, UprightLasersKeepTheirYaw) {
  for (const double yaw : {-3.0, -0.5, 0.0, 2.0}) {
    const auto answer = laserMountFrom(mount(yaw, 0.0));
    ASSERT_TRUE(answer.value) << answer.problem;
    EXPECT_FALSE(answer.value->upside_down);
    EXPECT_NEAR(answer.value->T_base_laser.theta, yaw, 1e-12);
    EXPECT_EQ(answer.value->T_base_laser.x, 0.1);
    EXPECT_EQ(answer.value->T_base_laser.y, 0.2);
  }
}

TEST(LaserMount, LasersUpsideDownAreRecognised) {
  const auto answer = laserMountFrom(mount(0.75, kPi));
  ASSERT_TRUE(answer.value) << answer.problem;
  EXPECT_TRUE(answer.value->upside_down);
  EXPECT_NEAR(answer.value->T_base_laser.theta, 0.75, 1e-12);
}

TEST(LaserMount, LittleTiltsPassAndGreatOnesAreRefused) {
  EXPECT_TRUE(laserMountFrom(mount(0.3, 0.04)).value);
  EXPECT_TRUE(laserMountFrom(mount(0.3, kPi - 0.04)).value);
  for (const double roll : {0.06, kPi / 2.0, kPi - 0.06, -0.06}) {
    const auto answer = laserMountFrom(mount(0.3, roll));
    EXPECT_FALSE(answer.value) << roll;
    EXPECT_NE(answer.problem.find("'laser'"), std::string::npos) << answer.problem;
    EXPECT_NE(answer.problem.find("'base_link'"), std::string::npos) << answer.problem;
    EXPECT_NE(answer.problem.find("12.500000"), std::string::npos) << answer.problem;
  }
}

TEST(LaserMount, WhatIsNoRigidMotionIsRefused) {
  auto transform = mount(0.0, 0.0);
  transform.transform.rotation.w = 0.0;
  EXPECT_FALSE(laserMountFrom(transform).value);
  transform = mount(0.0, 0.0);
  transform.transform.translation.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(laserMountFrom(transform).value);
}

TEST(FrameName, LosesTheSlashOfTf1) {
  EXPECT_EQ(frameName("/laser"), "laser");
  EXPECT_EQ(frameName("robot/laser"), "robot/laser");
  EXPECT_EQ(frameName("/"), "");
  EXPECT_EQ(frameName(""), "");
}

class TfBufferTest : public Test {
 protected:
  TfBufferTest() { ros::Time::init(); }
  tf2::BufferCore buffer_;
};

TEST_F(TfBufferTest, AMissingLaserIsNotInventedAndBothFramesAreNamed) {
  const auto answer = lookupLaserMount(buffer_, "base_link", "/laser", ros::Time(3, 250000000));
  EXPECT_FALSE(answer.value);
  EXPECT_NE(answer.problem.find("'laser'"), std::string::npos) << answer.problem;
  EXPECT_NE(answer.problem.find("'base_link'"), std::string::npos) << answer.problem;
  EXPECT_NE(answer.problem.find("3.250000"), std::string::npos) << answer.problem;
}

TEST_F(TfBufferTest, ALaserIsFoundBeforeAndAfterItsTransformsTime) {
  buffer_.setTransform(mount(0.5, 0.0), "test");
  for (const int seconds : {10, 12, 20}) {
    const auto answer = lookupLaserMount(buffer_, "/base_link", "/laser", ros::Time(seconds, 0));
    ASSERT_TRUE(answer.value) << answer.problem;
    EXPECT_NEAR(answer.value->T_base_laser.theta, 0.5, 1e-12);
  }
}

TEST_F(TfBufferTest, OdometryIsTheNewestTransformAtItsOwnTime) {
  EXPECT_FALSE(lookupOdometry(buffer_, "odom", "base_link").value);
  geometry_msgs::TransformStamped transform = mount(0.5, 0.0);
  transform.header.frame_id = "odom";
  transform.child_frame_id = "base_link";
  buffer_.setTransform(transform, "test");
  transform.header.stamp = ros::Time(13);
  transform.transform.translation.x = 0.7;
  buffer_.setTransform(transform, "test");
  const auto answer = lookupOdometry(buffer_, "odom", "base_link");
  ASSERT_TRUE(answer.value) << answer.problem;
  EXPECT_EQ(answer.value->stamp, 13.0);
  EXPECT_EQ(answer.value->pose.x, 0.7);
}

}  // namespace
}  // namespace omega_slam

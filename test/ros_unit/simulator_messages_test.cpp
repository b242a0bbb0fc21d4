#include "nodes/common/simulator_messages.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <cmath>
#include <limits>

#include "nodes/common/conversions.h"

namespace omega_slam {
namespace {

simulation::OdometrySample sample() {
  simulation::OdometrySample sample;
  sample.stamp = 12.34;
  sample.T_odom_base = {1.0, -2.0, 0.5};
  sample.velocity = {0.3, -0.4};
  sample.left = {5.0, 6.0};
  sample.right = {7.0, 8.0};
  return sample;
}

TEST(SimulatorMessages, OdometryComesBackAsItWas) {
  const nav_msgs::Odometry message = odometryToRos(sample(), "odom", "base_footprint");
  const auto pose = poseFromRos(message.pose.pose);
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->vector().isApprox(sample().T_odom_base.vector()));
  EXPECT_EQ(message.twist.twist.linear.x, 0.3);
  EXPECT_EQ(message.twist.twist.angular.z, -0.4);
  EXPECT_EQ(message.header.stamp, ros::Time(12, 340000000));
  EXPECT_EQ(message.pose.covariance[35], 0.05);
}

TEST(SimulatorMessages, TheTransformIsTheOdometrys) {
  const auto transform = odometryTransform(sample(), "odom", "base_footprint");
  const auto pose = poseFromRos(transform.transform);
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->vector().isApprox(sample().T_odom_base.vector()));
  EXPECT_EQ(transform.child_frame_id, "base_footprint");
}

TEST(SimulatorMessages, LeftIsTheFirstWheel) {
  const sensor_msgs::JointState joints = jointStatesToRos(sample());
  EXPECT_EQ(joints.name.front(), "wheel_left_joint");
  EXPECT_EQ(joints.position, (std::vector<double>{5.0, 7.0}));
  EXPECT_EQ(joints.velocity, (std::vector<double>{6.0, 8.0}));
}

TEST(SimulatorMessages, ScanKeepsItsRangesAndSaysItsLastAngle) {
  sensing::LaserScan scan;
  scan.stamp = 2.0;
  scan.angle_min = -1.0;
  scan.angle_increment = 0.5;
  scan.time_increment = 0.01;
  scan.range_max = 4.0;
  scan.ranges = {1.0F, std::numeric_limits<float>::quiet_NaN(),
                 std::numeric_limits<float>::infinity()};
  const sensor_msgs::LaserScan message = laserScanToRos(scan, "laser");
  EXPECT_FLOAT_EQ(message.angle_max, 0.0F);
  EXPECT_NEAR(message.scan_time, 0.01 * 2.0 * geometry::kPi / 0.5, 1e-6);
  ASSERT_EQ(message.ranges.size(), 3U);
  EXPECT_EQ(message.ranges[0], 1.0F);
  EXPECT_TRUE(std::isnan(message.ranges[1]));
  EXPECT_TRUE(std::isinf(message.ranges[2]));
  EXPECT_EQ(message.header.stamp, ros::Time(2, 0));
}

TEST(SimulatorMessages, EverySwitchIsAPointOfItsOwn) {
  for (int pressed = 0; pressed < 8; ++pressed) {
    const simulation::Bumper bumper{(pressed & 1) != 0, (pressed & 2) != 0, (pressed & 4) != 0};
    const auto cloud = bumperToRos(bumper, ros::Time(1, 0), "base_link");
    ASSERT_EQ(cloud.width * cloud.height, 3U);
    sensor_msgs::PointCloud2ConstIterator<float> point(cloud, "x");
    for (int one = 0; one < 3; ++one, ++point) {
      const double distance = std::hypot(point[0], point[1]);
      EXPECT_NEAR(distance, (pressed >> one & 1) != 0 ? 0.25 : 100.0, 1e-4);
      // Left, centre, right.
      EXPECT_EQ(point[1] > 0.0F, one == 0);
      EXPECT_EQ(point[1] < 0.0F, one == 2);
    }
  }
}

}  // namespace
}  // namespace omega_slam

#include "nodes/common/simulator_messages.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <array>
#include <cmath>

#include "nodes/common/conversions.h"

namespace omega_slam {
namespace {

constexpr float kPressedDistance = 0.25F;  // [m] defaults of kobuki_bumper2pc
constexpr float kIdleDistance = 100.0F;
constexpr float kBumperHeight = 0.04F;
constexpr double kSideAngle = 0.34906585;  // [rad] of the side points off the robot's y axis

/// One switch: its unit direction and whether it is pressed.
struct Switch {
  float x;
  float y;
  bool pressed;
};

geometry_msgs::Twist twistToRos(const simulation::Twist2& velocity) {
  geometry_msgs::Twist twist;
  twist.linear.x = velocity.linear;
  twist.angular.z = velocity.angular;
  return twist;
}

nav_msgs::Odometry kobukiOdometry() {
  constexpr double kUnknown = 1e10;
  nav_msgs::Odometry message;
  const std::array<double, 6> variances{0.1, 0.1, kUnknown, kUnknown, kUnknown, 0.05};
  for (std::size_t i = 0; i < variances.size(); ++i) {
    message.pose.covariance[7 * i] = variances[i];
  }
  return message;
}

}  // namespace

nav_msgs::Odometry odometryToRos(const simulation::OdometrySample& sample,
                                 const std::string& odom_frame, const std::string& base_frame) {
  nav_msgs::Odometry message = kobukiOdometry();
  message.header.stamp = timeToRos(sample.stamp);
  message.header.frame_id = odom_frame;
  message.child_frame_id = base_frame;
  message.pose.pose = poseToRos(sample.T_odom_base);
  message.twist.twist = twistToRos(sample.velocity);
  return message;
}

geometry_msgs::TransformStamped odometryTransform(const simulation::OdometrySample& sample,
                                                  const std::string& odom_frame,
                                                  const std::string& base_frame) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = timeToRos(sample.stamp);
  message.header.frame_id = odom_frame;
  message.child_frame_id = base_frame;
  message.transform = transformToRos(sample.T_odom_base);
  return message;
}

sensor_msgs::JointState jointStatesToRos(const simulation::OdometrySample& sample) {
  sensor_msgs::JointState message;
  message.header.stamp = timeToRos(sample.stamp);
  message.name = {"wheel_left_joint", "wheel_right_joint"};
  message.position = {sample.left.angle, sample.right.angle};
  message.velocity = {sample.left.speed, sample.right.speed};
  message.effort = {0.0, 0.0};
  return message;
}

nav_msgs::Odometry groundTruthToRos(const simulation::GroundTruth& truth,
                                    const std::string& world_frame, const std::string& base_frame) {
  nav_msgs::Odometry message;
  message.header.stamp = timeToRos(truth.stamp);
  message.header.frame_id = world_frame;
  message.child_frame_id = base_frame;
  message.pose.pose = poseToRos(truth.T_world_base);
  message.twist.twist = twistToRos(truth.velocity);
  return message;
}

sensor_msgs::LaserScan laserScanToRos(const sensing::LaserScan& scan,
                                      const std::string& laser_frame) {
  sensor_msgs::LaserScan message;
  message.header.stamp = timeToRos(scan.stamp);
  message.header.frame_id = laser_frame;
  message.angle_min = static_cast<float>(scan.angle_min);
  message.angle_increment = static_cast<float>(scan.angle_increment);
  const auto last_beam = static_cast<double>(scan.ranges.size()) - 1.0;
  message.angle_max = static_cast<float>(scan.angle_min + last_beam * scan.angle_increment);
  message.time_increment = static_cast<float>(scan.time_increment);
  // A turn of the mirror is as many increments as fill a circle.
  message.scan_time =
      static_cast<float>(scan.time_increment * 2.0 * geometry::kPi / scan.angle_increment);
  message.range_min = static_cast<float>(scan.range_min);
  message.range_max = static_cast<float>(scan.range_max);
  message.ranges = scan.ranges;
  return message;
}

sensor_msgs::PointCloud2 bumperToRos(const simulation::Bumper& bumper, const ros::Time& stamp,
                                     const std::string& bumper_frame) {
  const auto side_x = static_cast<float>(std::sin(kSideAngle));
  const auto side_y = static_cast<float>(std::cos(kSideAngle));
  const std::array<Switch, 3> switches{Switch{side_x, side_y, bumper.left},
                                       Switch{1.0F, 0.0F, bumper.centre},
                                       Switch{side_x, -side_y, bumper.right}};
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = stamp;
  cloud.header.frame_id = bumper_frame;
  cloud.height = 1;
  cloud.is_dense = true;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2Fields(3, "x", 1, sensor_msgs::PointField::FLOAT32,  //
                                "y", 1, sensor_msgs::PointField::FLOAT32,     //
                                "z", 1, sensor_msgs::PointField::FLOAT32);
  modifier.resize(switches.size());
  sensor_msgs::PointCloud2Iterator<float> point(cloud, "x");
  for (const Switch& one : switches) {
    const float distance = one.pressed ? kPressedDistance : kIdleDistance;
    point[0] = distance * one.x;
    point[1] = distance * one.y;
    point[2] = kBumperHeight;
    ++point;
  }
  return cloud;
}

}  // namespace omega_slam

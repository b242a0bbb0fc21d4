#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>

#include "omega_slam/simulation/turtlebot.h"

/// What a TurtleBot says, as its drivers say it. Pure functions.
namespace omega_slam {

/// Covariances are the constants of kobuki_node: 0.1 m^2 for x and y, 0.05 rad^2 for yaw (it has a
/// gyro), 1e10 for what a base on wheels cannot know; those of the twist are left at zero.
[[nodiscard]] nav_msgs::Odometry odometryToRos(const simulation::OdometrySample& sample,
                                               const std::string& odom_frame,
                                               const std::string& base_frame);

/// `T_odom_base` for tf.
[[nodiscard]] geometry_msgs::TransformStamped odometryTransform(
    const simulation::OdometrySample& sample, const std::string& odom_frame,
    const std::string& base_frame);

/// Joints wheel_left_joint and wheel_right_joint.
[[nodiscard]] sensor_msgs::JointState jointStatesToRos(const simulation::OdometrySample& sample);

/// The true pose, in the frame of the world's map; covariances are zero, for there is no doubt.
[[nodiscard]] nav_msgs::Odometry groundTruthToRos(const simulation::GroundTruth& truth,
                                                  const std::string& world_frame,
                                                  const std::string& base_frame);

[[nodiscard]] sensor_msgs::LaserScan laserScanToRos(const sensing::LaserScan& scan,
                                                    const std::string& laser_frame);

/// Left, centre and right switch as points, as kobuki_bumper2pc sends them: pressed ones 0.25 m
/// from the robot's middle, the others 100 m away, where no costmap takes note of them.
[[nodiscard]] sensor_msgs::PointCloud2 bumperToRos(const simulation::Bumper& bumper,
                                                   const ros::Time& stamp,
                                                   const std::string& bumper_frame);

}  // namespace omega_slam

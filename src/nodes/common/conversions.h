#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Transform.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <omega_slam/Pose2.h>
#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/sensing/laser_scan.h"

/// Between ROS messages and the library's types. Pure functions. Messages come from anywhere, so
/// reading one that can be wrong gives an optional; writing can't fail.
namespace omega_slam {

/// Seconds as a ROS time, to the nanosecond; times that ROS can't express become the nearest it
/// can.
[[nodiscard]] ros::Time timeToRos(double seconds);

/// Whether four numbers are finite and, up to rounding, a unit quaternion.
[[nodiscard]] bool isRotation(const geometry_msgs::Quaternion& quaternion);

/// The plane's share of a pose in space: x, y and yaw, this to the nearest 2^-40 rad, so that a
/// pose read here and sent on is read again as the same, to the last bit. None if a number is not
/// finite or the quaternion is no rotation.
[[nodiscard]] std::optional<geometry::Pose2> poseFromRos(const geometry_msgs::Pose& pose);
[[nodiscard]] std::optional<geometry::Pose2> poseFromRos(const geometry_msgs::Transform& transform);
[[nodiscard]] std::optional<geometry::Pose2> poseFromRos(const omega_slam::Pose2& pose);

[[nodiscard]] geometry_msgs::Pose poseToRos(const geometry::Pose2& pose);
[[nodiscard]] geometry_msgs::Transform transformToRos(const geometry::Pose2& pose);
[[nodiscard]] omega_slam::Pose2 pose2ToRos(const geometry::Pose2& pose);

/// The rows and columns x, y, yaw of a 6x6 covariance in ROS's order (x, y, z, rotX, rotY, rotZ).
/// None if one of the nine numbers is not finite or a variance is negative.
[[nodiscard]] std::optional<Eigen::Matrix3d> covarianceFromRos(
    const geometry_msgs::PoseWithCovariance::_covariance_type& covariance);
/// Elements outside of the plane are zero.
[[nodiscard]] geometry_msgs::PoseWithCovariance::_covariance_type covarianceToRos(
    const Eigen::Matrix3d& covariance);

/// As it is, faults included: sensing::ScanIntake knows what to do with them.
[[nodiscard]] sensing::LaserScan scanFromRos(const sensor_msgs::LaserScan& scan);

/// @param stamp of the newest keyframe drawn
[[nodiscard]] nav_msgs::OccupancyGrid gridToRos(const grid::OccupancyGrid& grid,
                                                const std::string& frame, const ros::Time& stamp);
/// A rectangle of the grid's cells, inside of the grid; both corners are inclusive.
[[nodiscard]] map_msgs::OccupancyGridUpdate gridUpdateToRos(const grid::OccupancyGrid& grid,
                                                            const Eigen::AlignedBox<int, 2>& cells,
                                                            const std::string& frame,
                                                            const ros::Time& stamp);
/// None if the size does not fit the cells, the resolution is not positive, the origin is not
/// finite or is turned, or a cell is outside of -1..100.
[[nodiscard]] std::optional<grid::OccupancyGrid> gridFromRos(const nav_msgs::OccupancyGrid& grid);

}  // namespace omega_slam

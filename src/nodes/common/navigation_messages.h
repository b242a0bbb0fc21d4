#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <ros/time.h>
#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "nodes/common/tf_lookup.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/navigation/costmap.h"
#include "omega_slam/navigation/path.h"

/// What the navigator says and hears, between ROS messages and the library's types.
namespace omega_slam {

/// Poses that look along the path; the last one looks to `heading` [rad].
[[nodiscard]] nav_msgs::Path pathToRos(const navigation::Path& path, double heading,
                                       const std::string& frame, const ros::Time& stamp);
[[nodiscard]] nav_msgs::Path posesToRos(const std::vector<geometry::Pose2>& poses,
                                        const std::string& frame, const ros::Time& stamp);

/// As costmap_2d shows its own: 100 in obstacles, 99 where the robot would touch one, less the more
/// room there is, -1 where nothing is known.
/// @param cost says from which clearance on room does not matter
[[nodiscard]] nav_msgs::OccupancyGrid costmapToRos(const navigation::Costmap& costmap,
                                                   const navigation::ClearanceCost& cost,
                                                   const std::string& frame,
                                                   const ros::Time& stamp);

/// Where a bumper's points, float fields x and y, say that it is pressed, in the base frame [m].
/// One that is not pressed says so by a point far away: beyond two radii of the robot.
/// @return no value if tf does not know where the bumper is
[[nodiscard]] TfAnswer<std::vector<Eigen::Vector2d>> contactsOf(
    const sensor_msgs::PointCloud2& bumper, double robot_radius, const std::string& base_frame,
    const tf2::BufferCore& buffer);

}  // namespace omega_slam

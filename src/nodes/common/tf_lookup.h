#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/laser_scan.h"

namespace omega_slam {

/// A frame's name as tf2 wants it: without the leading '/' that tf1 allowed.
[[nodiscard]] std::string frameName(const std::string& frame);

/// An answer from tf, or a sentence that names both frames and the stamp. Nothing is ever invented.
template <class T>
struct TfAnswer {
  std::optional<T> value;
  std::string problem;
};

/// Reads the mount of a planar laser off `T_base_laser`.
/// @return no value if the laser is tilted by more than 0.05 rad from upright or upside down, or if
/// the transform is no rigid motion
[[nodiscard]] TfAnswer<sensing::LaserMount> laserMountFrom(
    const geometry_msgs::TransformStamped& transform);

/// The laser in the base frame at the stamp. A laser is bolted down, so where tf does not reach to
/// the stamp (robot_state_publisher may be as slow as 5 Hz) its newest transform says the same.
[[nodiscard]] TfAnswer<sensing::LaserMount> lookupLaserMount(const tf2::BufferCore& buffer,
                                                             const std::string& base_frame,
                                                             const std::string& laser_frame,
                                                             const ros::Time& stamp);

/// The pose of frame b in frame a, `T_a_b`, at a stamp; the newest that there is where that is
/// zero.
[[nodiscard]] TfAnswer<geometry::StampedPose2> lookupPose(const tf2::BufferCore& buffer,
                                                          const std::string& frame_a,
                                                          const std::string& frame_b,
                                                          const ros::Time& stamp);

/// The newest pose of the base in the odometry frame, `T_odom_base`, at its own stamp.
[[nodiscard]] TfAnswer<geometry::StampedPose2> lookupOdometry(const tf2::BufferCore& buffer,
                                                              const std::string& odom_frame,
                                                              const std::string& base_frame);

}  // namespace omega_slam

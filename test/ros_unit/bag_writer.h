#pragma once

#include <geometry_msgs/Transform.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <filesystem>
#include <string>

#include "nodes/common/conversions.h"
#include "omega_slam/geometry/pose2.h"

namespace omega_slam::test {

/// Writes small bags for tests. Stamps [s] are also the times of recording, unless said otherwise.
class BagWriter {
 public:
  explicit BagWriter(const std::filesystem::path& path) {
    bag_.open(path.string(), rosbag::bagmode::Write);
  }

  /// Eleven beams from -0.5 to 0.5 rad, one every `time_increment` [s].
  void scan(double stamp, double time_increment = 0.0, const std::string& frame = "laser",
            const std::string& topic = "/scan") {
    scanRecordedAt(stamp, stamp, time_increment, frame, topic);
  }

  void scanRecordedAt(double recorded, double stamp, double time_increment = 0.0,
                      const std::string& frame = "laser", const std::string& topic = "/scan") {
    sensor_msgs::LaserScan message;
    message.header.stamp.fromSec(stamp);
    message.header.frame_id = frame;
    message.angle_min = -0.5F;
    message.angle_max = 0.5F;
    message.angle_increment = 0.1F;
    message.time_increment = static_cast<float>(time_increment);
    message.range_max = 4.0F;
    message.ranges.assign(11, 1.0F);
    bag_.write(topic, ros::Time(recorded), message);
  }

  void odometry(double stamp, const geometry::Pose2& T_odom_base,
                const std::string& child = "base_link", const std::string& topic = "/odom") {
    odometryRecordedAt(stamp, stamp, T_odom_base, child, topic);
  }

  void odometryRecordedAt(double recorded, double stamp, const geometry::Pose2& T_odom_base,
                          const std::string& child = "base_link",
                          const std::string& topic = "/odom") {
    nav_msgs::Odometry message;
    message.header.stamp.fromSec(stamp);
    message.header.frame_id = "odom";
    message.child_frame_id = child;
    message.pose.pose = poseToRos(T_odom_base);
    bag_.write(topic, ros::Time(recorded), message);
  }

  void transform(double stamp, const std::string& parent, const std::string& child,
                 const geometry::Pose2& pose, const std::string& topic = "/tf") {
    transform(stamp, parent, child, transformToRos(pose), topic);
  }

  void transform(double stamp, const std::string& parent, const std::string& child,
                 const geometry_msgs::Transform& transform, const std::string& topic = "/tf") {
    bag_.write(topic, ros::Time(stamp), transformMessage(stamp, parent, child, transform));
  }

  void transformRecordedAt(double recorded, double stamp, const std::string& parent,
                           const std::string& child, const geometry::Pose2& pose) {
    bag_.write("/tf", ros::Time(recorded),
               transformMessage(stamp, parent, child, transformToRos(pose)));
  }

  template <class Message>
  void message(double stamp, const std::string& topic, const Message& message) {
    bag_.write(topic, ros::Time(stamp), message);
  }

  [[nodiscard]] static tf2_msgs::TFMessage transformMessage(
      double stamp, const std::string& parent, const std::string& child,
      const geometry_msgs::Transform& transform) {
    tf2_msgs::TFMessage message;
    message.transforms.resize(1);
    message.transforms[0].header.stamp.fromSec(stamp);
    message.transforms[0].header.frame_id = parent;
    message.transforms[0].child_frame_id = child;
    message.transforms[0].transform = transform;
    return message;
  }

  void close() { bag_.close(); }

 private:
  rosbag::Bag bag_;
};

/// A rotation about the x axis [rad], as of a laser that is mounted upside down or tilted.
inline geometry_msgs::Transform rolled(double roll) {
  geometry_msgs::Transform transform;
  transform.rotation.x = std::sin(0.5 * roll);
  transform.rotation.w = std::cos(0.5 * roll);
  return transform;
}

}  // namespace omega_slam::test

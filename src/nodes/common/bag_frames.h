#pragma once

#include <rosbag/bag.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nodes/common/bag_topics.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/laser_scan.h"

namespace omega_slam {

/// The tf of a bag, fed message by message in the order of the recording. Frames lose the leading
/// '/' that tf1 allowed. Where the clock jumps back, what moves is forgotten; what is static stays.
/// Not thread-safe.
class BagFrames {
 public:
  /// @param is_static whether the message came on tf_static
  void add(const tf2_msgs::TFMessage& message, bool is_static);

  [[nodiscard]] const tf2::BufferCore& buffer() const { return buffer_; }

  /// Whether there is a way between two frames at one moment at least.
  [[nodiscard]] bool connects(const std::string& a, const std::string& b) const;
  /// "odom -> base_link, base_link -> laser": what has been seen, for messages.
  [[nodiscard]] std::string links() const;

 private:
  void forgetIfClockJumpedBack(const geometry_msgs::TransformStamped& transform);

  tf2::BufferCore buffer_;
  std::map<std::string, std::string> parents_;  ///< by child
  std::map<std::string, double> newest_;        ///< [s] stamp of each moving child's transform
};

/// Which frames of a bag play which part.
struct BagRoles {
  std::string base_frame;
  sensing::LaserMount mount;
};

/// What is already known when roles are looked for.
struct BagRoleRequest {
  std::string laser_frame;  ///< of the scans
  /// Frames that may be the robot's base, the best first.
  std::vector<std::string> base_frames;
  /// The odometry's frame, which tf must link to the base; empty where messages give the odometry.
  std::string odom_frame;
  std::optional<geometry::Pose2> laser_pose;  ///< `T_base_laser` where the user gives it
};

/// Reads the bag's tf until all roles are filled.
/// @throws BagError if the bag ends before that, naming the frames between which tf says nothing
[[nodiscard]] BagRoles findRoles(const rosbag::Bag& bag, const std::string& path,
                                 const BagTopics& topics, const BagRoleRequest& request);

}  // namespace omega_slam

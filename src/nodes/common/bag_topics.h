#pragma once

#include <rosbag/bag.h>
#include <rosbag/message_instance.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace omega_slam {

/// A bag that can't be used. what() is a sentence that says why, and what is in the bag.
class BagError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The topics that a log of laser scans and odometry is read from.
struct BagTopics {
  std::string scan;
  std::string odometry;         ///< nav_msgs/Odometry; empty: the odometry comes from tf
  std::vector<std::string> tf;  ///< tf and tf_static, under either type that they have had
};

/// @throws BagError if the file can't be read, is not a bag, or has no index
void openBag(rosbag::Bag& bag, const std::string& path);

/// Finds the topics by their types. Where a bag holds several of Odometry, `odom` is meant.
/// @param scan_topic     empty: the only one there is
/// @param odometry_topic empty: any; "tf": none, tf instead
/// @throws BagError if there is nothing to choose, or too much
[[nodiscard]] BagTopics chooseTopics(const rosbag::Bag& bag, const std::string& path,
                                     const std::string& scan_topic,
                                     const std::string& odometry_topic);

/// rosbag believes any length that it reads, and reads on beyond the end of what it holds.
/// @throws BagError if the message claims to be longer than the bag
void requireSaneSize(const rosbag::MessageInstance& instance, const rosbag::Bag& bag,
                     const std::string& path);

/// Whether the transforms of a topic hold for all time.
[[nodiscard]] bool isStaticTf(const std::string& topic);

/// "It holds: /scan (sensor_msgs/LaserScan), ..."
[[nodiscard]] std::string listTopics(const rosbag::Bag& bag);

}  // namespace omega_slam

#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "nodes/common/bag_frames.h"
#include "nodes/common/bag_topics.h"
#include "nodes/common/scan_queue.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/io/scan_source.h"
#include "omega_slam/motion/odometry_buffer.h"
#include "omega_slam/sensing/laser_scan.h"

namespace omega_slam {

/// What the user says of a bag where it does not speak for itself.
struct BagLogOptions {
  std::string scan_topic;          ///< empty: the only topic of laser scans
  std::string odometry_topic;      ///< empty: messages if there are any, else tf; "tf": always tf
  std::string odom_frame{"odom"};  ///< of the odometry in tf
  /// The robot's base, whose pose the odometry tells; empty: the child frame of the odometry's
  /// messages, else base_footprint, else base_link.
  std::string base_frame;
  std::optional<geometry::Pose2> laser_pose;  ///< `T_base_laser`; none: as tf says
};

/// What has been found and counted so far. Causes are short stable phrases.
struct BagLogReport {
  std::string scan_topic;
  std::string odometry;  ///< "/odom", or "tf odom -> base_link"
  std::string base_frame;
  std::string laser_frame;
  sensing::LaserMount mount;
  std::size_t scans{0};                                 ///< read from the bag
  std::size_t records{0};                               ///< of these, handed out
  std::map<std::string, std::size_t> dropped_scans;     ///< by cause
  std::size_t odometry_poses{0};                        ///< read and used
  std::map<std::string, std::size_t> dropped_odometry;  ///< by cause
};

/// Reads scans and odometry from a rosbag, as fast as the disk allows, without a ROS master. Scans
/// wait until the odometry has reached them, by the time of the messages. Not thread-safe.
class BagLog : public io::ScanSource {
 public:
  /// @throws BagError
  BagLog(const std::string& path, const BagLogOptions& options);

  /// The next scan that the odometry covers, by the stamps of those that wait; none at the end.
  /// @throws BagError if the bag is damaged from here on
  [[nodiscard]] std::optional<io::ScanRecord> next() override;

  [[nodiscard]] double progress() const override;
  [[nodiscard]] std::map<std::string, std::size_t> dropped() const override;
  [[nodiscard]] std::string description() const override;
  [[nodiscard]] const BagLogReport& report() const { return report_; }

 private:
  void findOut(const BagLogOptions& options);
  void startView();
  [[nodiscard]] bool readMessage();
  void readScan(const rosbag::MessageInstance& instance);
  void readOdometry(const rosbag::MessageInstance& instance);
  void readTransforms(const rosbag::MessageInstance& instance);
  void addOdometry(double stamp, const geometry::Pose2& T_odom_base);
  [[nodiscard]] std::optional<io::ScanRecord> takeReady();  ///< the odometry covers all of it
  [[nodiscard]] std::optional<io::ScanRecord>
  takeLast();  ///< at the end: all of it or its beginning
  [[nodiscard]] io::ScanRecord makeRecord(WaitingScan scan);
  void dropScan(const std::string& cause) { ++report_.dropped_scans[cause]; }

  std::string path_;
  rosbag::Bag bag_;
  BagTopics topics_;
  BagFrames frames_;
  std::string odom_frame_;
  std::unique_ptr<rosbag::View> view_;
  std::optional<rosbag::View::iterator> message_;  ///< the next to be read
  std::size_t messages_read_{0};
  std::size_t messages_{0};
  motion::OdometryBuffer odometry_;
  ScanQueue waiting_;
  BagLogReport report_;
};

}  // namespace omega_slam

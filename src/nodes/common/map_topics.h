#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

#include <functional>
#include <mutex>
#include <string>

#include "nodes/common/map_worker.h"
#include "omega_slam/mapping/map_raster.h"

namespace omega_slam {

/// A map as ROS knows it, on four topics: `map` and `map_probability` whole, `map_updates` with the
/// cells that have changed, `map_metadata`. A message that nobody would get is not made, and who
/// subscribes late to a whole map is sent the newest. Thread-safe.
class MapTopics {
 public:
  /// The newest map, or null; asked in any thread.
  using Newest = std::function<DrawnMapPtr()>;

  /// @param always_send_whole_map also where `map_updates` would do
  MapTopics(ros::NodeHandle nh, std::string frame, bool always_send_whole_map, Newest newest);

  /// A map that came after all before.
  void publish(const DrawnMap& map);

  /// The same grid as on `map`.
  [[nodiscard]] nav_msgs::OccupancyGrid whole(const DrawnMap& map) const;

 private:
  [[nodiscard]] ros::Publisher advertise(const std::string& topic, mapping::MapLayer layer);
  void sendTo(const ros::SingleSubscriberPublisher& subscriber, mapping::MapLayer layer);
  void publishVerdicts(const DrawnMap& map);
  [[nodiscard]] nav_msgs::OccupancyGrid message(const grid::OccupancyGrid& grid,
                                                double stamp) const;

  ros::NodeHandle nh_;
  std::string frame_;
  bool always_send_whole_map_;
  Newest newest_;
  std::mutex mutex_;  ///< guards the rasters, and keeps what a subscriber gets in order
  mapping::MapRaster verdicts_{mapping::MapLayer::kVerdict};
  mapping::MapRaster probabilities_{mapping::MapLayer::kProbability};
  // Last, so that no subscriber is served before the members above exist.
  ros::Publisher metadata_publisher_;
  ros::Publisher update_publisher_;
  ros::Publisher map_publisher_;
  ros::Publisher probability_publisher_;
};

}  // namespace omega_slam

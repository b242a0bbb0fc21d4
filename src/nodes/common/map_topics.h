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
/// cells that have changed, `map_metadata`. All but the updates are latched; and where what was
/// latched is not the newest any more, who subscribes late is sent that too. Thread-safe.
class MapTopics {
 public:
  /// The newest map, or null; asked in any thread.
  using Newest = std::function<DrawnMapPtr()>;

  /// @param always_send_whole_map also where `map_updates` would do
  MapTopics(ros::NodeHandle nh, std::string frame, bool always_send_whole_map, Newest newest);

  /// A map that came after all before.
  void publish(const DrawnMapPtr& map);

  /// The same grid as on `map`.
  [[nodiscard]] nav_msgs::OccupancyGrid whole(const DrawnMap& map) const;

 private:
  /// A topic with a whole map.
  struct Whole {
    mapping::MapRaster raster;
    DrawnMapPtr latched;
    ros::Publisher publisher;
  };
  void advertise(const std::string& topic, Whole& whole);
  void sendTo(const ros::SingleSubscriberPublisher& subscriber, const Whole& whole);
  void send(const DrawnMapPtr& map, Whole& whole);
  [[nodiscard]] nav_msgs::OccupancyGrid message(const grid::OccupancyGrid& grid,
                                                double stamp) const;

  ros::NodeHandle nh_;
  std::string frame_;
  bool always_send_whole_map_;
  Newest newest_;
  std::mutex mutex_;  ///< guards all below, and keeps what a subscriber gets in order
  ros::Publisher metadata_publisher_;
  ros::Publisher update_publisher_;
  Whole verdicts_{mapping::MapRaster(mapping::MapLayer::kVerdict), {}, {}};
  Whole probabilities_{mapping::MapRaster(mapping::MapLayer::kProbability), {}, {}};
};

}  // namespace omega_slam

#include "nodes/common/map_topics.h"

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/MapMetaData.h>

#include <utility>

#include "nodes/common/conversions.h"
#include "nodes/common/names.h"

namespace omega_slam {

using mapping::MapLayer;

MapTopics::MapTopics(ros::NodeHandle nh, std::string frame, bool always_send_whole_map,
                     Newest newest)
    : nh_(std::move(nh)),
      frame_(std::move(frame)),
      always_send_whole_map_(always_send_whole_map),
      newest_(std::move(newest)),
      metadata_publisher_(nh_.advertise<nav_msgs::MapMetaData>(names::kMapMetadata, 1, true)),
      update_publisher_(nh_.advertise<map_msgs::OccupancyGridUpdate>(names::kMapUpdates, 10)) {
  advertise(names::kMap, verdicts_);
  advertise(names::kMapProbability, probabilities_);
}

void MapTopics::advertise(const std::string& topic, Whole& whole) {
  whole.publisher = nh_.advertise<nav_msgs::OccupancyGrid>(
      topic, 1,
      [this, &whole](const ros::SingleSubscriberPublisher& subscriber) {
        sendTo(subscriber, whole);
      },
      ros::SubscriberStatusCallback(), ros::VoidConstPtr(), true);
}

void MapTopics::sendTo(const ros::SingleSubscriberPublisher& subscriber, const Whole& whole) {
  // Under the lock: what publish() sends next is at least as new.
  const std::lock_guard<std::mutex> lock(mutex_);
  const DrawnMapPtr map = newest_();
  if (map && map != whole.latched) {
    mapping::MapRaster raster(whole.raster.layer());
    raster.update(map->snapshot);
    subscriber.publish(message(raster.grid(), map->stamp));
  }
}

void MapTopics::publish(const DrawnMapPtr& map) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const mapping::RasterChange change = verdicts_.raster.update(map->snapshot);
  if (!change.is_resized && !change.cells.isEmpty() && update_publisher_.getNumSubscribers() > 0) {
    update_publisher_.publish(
        gridUpdateToRos(verdicts_.raster.grid(), change.cells, frame_, timeToRos(map->stamp)));
  }
  if (always_send_whole_map_ || change.is_resized) {
    send(map, verdicts_);
  }
  if (probabilities_.publisher.getNumSubscribers() > 0) {
    probabilities_.raster.update(map->snapshot);
    send(map, probabilities_);
  }
}

void MapTopics::send(const DrawnMapPtr& map, Whole& whole) {
  const nav_msgs::OccupancyGrid grid = message(whole.raster.grid(), map->stamp);
  whole.publisher.publish(grid);
  whole.latched = map;
  if (&whole == &verdicts_) {
    metadata_publisher_.publish(grid.info);
  }
}

nav_msgs::OccupancyGrid MapTopics::whole(const DrawnMap& map) const {
  mapping::MapRaster raster(MapLayer::kVerdict);
  raster.update(map.snapshot);
  return message(raster.grid(), map.stamp);
}

nav_msgs::OccupancyGrid MapTopics::message(const grid::OccupancyGrid& grid, double stamp) const {
  return gridToRos(grid, frame_, timeToRos(stamp));
}

}  // namespace omega_slam

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
      update_publisher_(nh_.advertise<map_msgs::OccupancyGridUpdate>(names::kMapUpdates, 10)),
      map_publisher_(advertise(names::kMap, MapLayer::kVerdict)),
      probability_publisher_(advertise(names::kMapProbability, MapLayer::kProbability)) {}

ros::Publisher MapTopics::advertise(const std::string& topic, MapLayer layer) {
  return nh_.advertise<nav_msgs::OccupancyGrid>(
      topic, 1, [this, layer](const ros::SingleSubscriberPublisher& subscriber) {
        sendTo(subscriber, layer);
      });
}

void MapTopics::sendTo(const ros::SingleSubscriberPublisher& subscriber, MapLayer layer) {
  // Under the lock: what publish() sends next is at least as new.
  const std::lock_guard<std::mutex> lock(mutex_);
  if (const DrawnMapPtr map = newest_()) {
    mapping::MapRaster raster(layer);
    raster.update(map->snapshot);
    subscriber.publish(message(raster.grid(), map->stamp));
  }
}

void MapTopics::publish(const DrawnMap& map) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (map_publisher_.getNumSubscribers() + update_publisher_.getNumSubscribers() > 0) {
    publishVerdicts(map);
  }
  if (probability_publisher_.getNumSubscribers() > 0) {
    probabilities_.update(map.snapshot);
    probability_publisher_.publish(message(probabilities_.grid(), map.stamp));
  }
  const grid::OccupancyGrid place{mapping::rasterGeometry(map.snapshot), {}};
  metadata_publisher_.publish(message(place, map.stamp).info);
}

void MapTopics::publishVerdicts(const DrawnMap& map) {
  const mapping::RasterChange change = verdicts_.update(map.snapshot);
  if (!change.is_resized && !change.cells.isEmpty() && update_publisher_.getNumSubscribers() > 0) {
    update_publisher_.publish(
        gridUpdateToRos(verdicts_.grid(), change.cells, frame_, timeToRos(map.stamp)));
  }
  if ((always_send_whole_map_ || change.is_resized) && map_publisher_.getNumSubscribers() > 0) {
    map_publisher_.publish(message(verdicts_.grid(), map.stamp));
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

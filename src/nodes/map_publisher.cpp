#include <nav_msgs/GetMap.h>
#include <nav_msgs/MapMetaData.h>
#include <ros/ros.h>

#include "nodes/common/conversions.h"
#include "nodes/common/diagnostics.h"
#include "nodes/common/names.h"
#include "nodes/common/node_config.h"
#include "nodes/common/node_runner.h"
#include "omega_slam/config/map_publisher_config.h"
#include "omega_slam/grid/map_file.h"

namespace omega_slam {
namespace {

/// A map from a file on the topics of map_builder, for a robot that navigates where it has mapped
/// before. Stands where map_server stands.
class MapPublisherNode {
 public:
  static constexpr unsigned kCallbackThreads = 1;

  /// @throws std::runtime_error where the file can't be used
  MapPublisherNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh)
      : config_(loadConfig<config::MapPublisherNodeConfig>(private_nh)),
        map_(load()),
        diagnostics_(nh, "map_publisher"),
        map_publisher_(nh.advertise<nav_msgs::OccupancyGrid>(names::kMap, 1, true)),
        metadata_publisher_(nh.advertise<nav_msgs::MapMetaData>(names::kMapMetadata, 1, true)),
        map_service_(
            nh.advertiseService(names::kStaticMapService, &MapPublisherNode::onStaticMap, this)) {
    map_publisher_.publish(map_);
    metadata_publisher_.publish(map_.info);
    diagnostics_.setHealth(diagnostic_msgs::DiagnosticStatus::OK, "publishing");
    diagnostics_.set("map_file", config_.map_file);
    ROS_INFO_STREAM("The map of " << config_.map_file << " (" << map_.info.width << " x "
                                  << map_.info.height << " cells of " << map_.info.resolution
                                  << " m) is published.");
  }

  void shutdown() {}

 private:
  [[nodiscard]] nav_msgs::OccupancyGrid load() const {
    return gridToRos(grid::toOccupancyGrid(grid::loadMapImage(config_.map_file)), config_.frame_id,
                     ros::Time::now());
  }

  bool onStaticMap(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response) {
    response.map = map_;
    return true;
  }

  const config::MapPublisherNodeConfig config_;
  const nav_msgs::OccupancyGrid map_;
  Diagnostics diagnostics_;
  ros::Publisher map_publisher_;
  ros::Publisher metadata_publisher_;
  ros::ServiceServer map_service_;
};

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  return omega_slam::runNode<omega_slam::MapPublisherNode>(argc, argv, "map_publisher");
}

#include "nodes/common/graph_pictures.h"

#include <nav_msgs/Path.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstddef>
#include <utility>

#include "nodes/common/conversions.h"
#include "nodes/common/graph_markers.h"
#include "nodes/common/names.h"

namespace omega_slam {
namespace {

std_msgs::Header headerOf(const GraphSnapshot& snapshot, const std::string& frame) {
  std_msgs::Header header;
  header.frame_id = frame;
  header.stamp = snapshot.newest();
  return header;
}

nav_msgs::Path pathOf(const GraphSnapshot& snapshot, const std::string& frame) {
  nav_msgs::Path path;
  path.header = headerOf(snapshot, frame);
  path.poses.resize(snapshot.stamps.size());
  for (std::size_t i = 0; i < snapshot.stamps.size(); ++i) {
    path.poses[i].header.frame_id = frame;
    path.poses[i].header.stamp = snapshot.stamps[i];
    path.poses[i].pose = poseToRos(snapshot.graph.poses[i]);
  }
  return path;
}

visualization_msgs::MarkerArray markersOf(const GraphSnapshot& snapshot, const std::string& frame) {
  return graphMarkers(snapshot.graph, headerOf(snapshot, frame));
}

}  // namespace

GraphPictures::GraphPictures(ros::NodeHandle nh, std::string map_frame)
    : map_frame_(std::move(map_frame)),
      path_publisher_(advertise<nav_msgs::Path>(nh, names::kTrajectory, pathOf)),
      marker_publisher_(
          advertise<visualization_msgs::MarkerArray>(nh, names::kPoseGraphMarkers, markersOf)) {}

template <typename Message, typename Draw>
ros::Publisher GraphPictures::advertise(ros::NodeHandle& nh, const char* topic, Draw draw) {
  return nh.advertise<Message>(topic, 1,
                               [this, draw](const ros::SingleSubscriberPublisher& subscriber) {
                                 const std::lock_guard<std::mutex> lock(mutex_);
                                 if (newest_) {
                                   subscriber.publish(draw(*newest_, map_frame_));
                                 }
                               });
}

void GraphPictures::show(const GraphSnapshotPtr& snapshot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  newest_ = snapshot;
  if (path_publisher_.getNumSubscribers() > 0) {
    path_publisher_.publish(pathOf(*snapshot, map_frame_));
  }
  if (marker_publisher_.getNumSubscribers() > 0) {
    marker_publisher_.publish(markersOf(*snapshot, map_frame_));
  }
}

}  // namespace omega_slam

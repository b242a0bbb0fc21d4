#pragma once

#include <ros/ros.h>

#include <mutex>
#include <string>

#include "nodes/common/graph_worker.h"

namespace omega_slam {

/// The graph for those who look at it: its keyframes as a path, and markers for rviz. They are as
/// large as the graph and of no use to any node, so that they are made for listeners alone: of
/// every new graph for those who are there, of the newest for who comes later.
class GraphPictures {
 public:
  GraphPictures(ros::NodeHandle nh, std::string map_frame);

  void show(const GraphSnapshotPtr& snapshot);  ///< in any thread

 private:
  template <typename Message, typename Draw>
  ros::Publisher advertise(ros::NodeHandle& nh, const char* topic, Draw draw);

  std::string map_frame_;
  std::mutex mutex_;
  GraphSnapshotPtr newest_;
  ros::Publisher path_publisher_;
  ros::Publisher marker_publisher_;
};

}  // namespace omega_slam

#include <fmt/format.h>
#include <nav_msgs/GetMap.h>
#include <omega_slam/Keyframe.h>
#include <omega_slam/PoseGraph.h>
#include <omega_slam/SaveMap.h>
#include <ros/ros.h>

#include <filesystem>
#include <mutex>
#include <string>

#include "nodes/common/diagnostics.h"
#include "nodes/common/keyframe_store.h"
#include "nodes/common/map_topics.h"
#include "nodes/common/map_worker.h"
#include "nodes/common/names.h"
#include "nodes/common/node_config.h"
#include "nodes/common/node_runner.h"
#include "nodes/common/slam_conversions.h"
#include "omega_slam/grid/map_file.h"

namespace omega_slam {
namespace {

/// [s] Time that drawing the last keyframes may take before a map without them is saved. Within it,
/// roslaunch still waits for a node that it has asked to end (15 s).
constexpr double kSavePatience = 10.0;

/// Keyframes and solved poses in, the map out. Drawing is a MapWorker's, in a thread of its own.
class MapBuilderNode {
 public:
  // Neither saving nor a new subscriber, who is sent the whole map, must hold up the keyframes.
  static constexpr unsigned kCallbackThreads = 3;

  MapBuilderNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh)
      : config_(loadConfig<config::MapBuilderNodeConfig>(private_nh)),
        diagnostics_(nh, "map_builder"),
        topics_(nh, config_.map_frame, config_.always_send_whole_map,
                [this] { return worker_.newest(); }),
        worker_(config_.mapper, config_.update_interval, diagnostics_,
                [this](const DrawnMapPtr& map) { topics_.publish(map); }) {
    diagnostics_.setHealth(diagnostic_msgs::DiagnosticStatus::OK, "waiting for keyframes");
    keyframe_subscriber_ =
        nh.subscribe(names::kKeyframe, names::kKeyframeQueue, &MapBuilderNode::onKeyframe, this);
    graph_subscriber_ = nh.subscribe(names::kPoseGraph, 1, &MapBuilderNode::onPoseGraph, this);
    map_service_ =
        nh.advertiseService(names::kDynamicMapService, &MapBuilderNode::onDynamicMap, this);
    save_service_ = nh.advertiseService(names::kSaveMapService, &MapBuilderNode::onSaveMap, this);
  }

  void shutdown() {
    if (config_.save_on_exit) {
      const auto result = save(config_.save_stem);
      ROS_INFO_STREAM(result.message);
    }
    worker_.stop();
  }

 private:
  void onKeyframe(const Keyframe::ConstPtr& message) {
    auto keyframe = keyframeFromRos(*message);
    if (!keyframe.value) {
      diagnostics_.reject(keyframe.fault);
      return;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    switch (store_.add(message->run, std::move(*keyframe.value))) {
      case KeyframeStore::Verdict::kKnown:
        return;
      case KeyframeStore::Verdict::kOtherRun:
        diagnostics_.reject(
            "keyframe of another run",
            fmt::format(
                "Keyframe {} does not belong to the map, and a new run begins with keyframe "
                "0.",
                message->id));
        return;
      case KeyframeStore::Verdict::kNewRun:
        ROS_INFO("A new run: the map begins anew.");
        diagnostics_.rearm();
        worker_.show({});
        break;
      case KeyframeStore::Verdict::kTaken:
        break;
    }
    diagnostics_.accept(message->header.stamp.toSec());
    show();
  }

  void onPoseGraph(const PoseGraph::ConstPtr& message) {
    auto poses = posesFromRos(*message);
    if (!poses.value) {
      diagnostics_.reject(poses.fault);
      return;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    store_.setPoses(message->run, std::move(*poses.value));
    show();
  }

  /// The caller holds the lock.
  void show() {
    worker_.show(store_.placed());
    diagnostics_.setHealth(diagnostic_msgs::DiagnosticStatus::OK, "drawing");
    diagnostics_.set("keyframes", static_cast<double>(store_.size()));
    diagnostics_.set("keyframes that the graph has and the map lacks",
                     static_cast<double>(store_.missing()));
  }

  bool onDynamicMap(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response) {
    const auto map = worker_.newest();
    if (!map) {
      ROS_WARN("There is no map yet: nothing has been drawn.");
      return false;
    }
    response.map = topics_.whole(*map);
    return true;
  }

  bool onSaveMap(SaveMap::Request& request, SaveMap::Response& response) {
    const auto result = save(request.path.empty() ? config_.save_stem : request.path);
    response.success = result.success;
    response.message = result.message;
    for (const auto& path : result.paths) {
      response.paths.push_back(path.string());
    }
    return true;
  }

  [[nodiscard]] grid::SaveResult save(const std::string& stem) {
    const auto map = worker_.complete(kSavePatience);
    if (!map) {
      return {false, "There is no map to save: nothing has been drawn yet.", {}};
    }
    const auto layer = config_.save_format.mode == grid::MapMode::kTrinary
                           ? mapping::MapLayer::kVerdict
                           : mapping::MapLayer::kProbability;
    auto result = grid::saveMap(mapping::render(map->snapshot, layer),
                                std::filesystem::absolute(stem), config_.save_format);
    diagnostics_.set("last save", result.message);
    if (!result.success) {
      ROS_WARN_STREAM(result.message);
    }
    return result;
  }

  config::MapBuilderNodeConfig config_;
  Diagnostics diagnostics_;
  MapTopics topics_;
  std::mutex mutex_;  ///< guards store_, and keeps what is shown in order
  KeyframeStore store_;
  MapWorker worker_;  ///< after all that it publishes by
  ros::Subscriber keyframe_subscriber_;
  ros::Subscriber graph_subscriber_;
  ros::ServiceServer map_service_;
  ros::ServiceServer save_service_;
};

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  return omega_slam::runNode<omega_slam::MapBuilderNode>(argc, argv, "map_builder");
}

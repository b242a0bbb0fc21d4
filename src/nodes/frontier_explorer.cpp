#include <actionlib/client/simple_action_client.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/OccupancyGrid.h>
#include <omega_slam/ExplorationStatus.h>
#include <omega_slam/Keyframe.h>
#include <omega_slam/PoseGraph.h>
#include <omega_slam/SetStrategy.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <visualization_msgs/MarkerArray.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nodes/common/conversions.h"
#include "nodes/common/diagnostics.h"
#include "nodes/common/exploration_markers.h"
#include "nodes/common/map_news.h"
#include "nodes/common/names.h"
#include "nodes/common/navigation_messages.h"
#include "nodes/common/node_config.h"
#include "nodes/common/node_runner.h"
#include "nodes/common/run_saver.h"
#include "nodes/common/slam_conversions.h"
#include "nodes/common/tf_lookup.h"
#include "omega_slam/config/exploration_config.h"

namespace omega_slam {
namespace {

using exploration::Explorer;
using exploration::Order;
using exploration::Phase;
using exploration::Reply;

constexpr double kPoseAge = 1.0;         // [s] an older pose is none
constexpr double kStatusInterval = 1.0;  // [s]

/// Map and pose in, goals for move_base out. All callbacks run in one thread, which owns everything
/// here; saving in the end is a RunSaver's, in a thread of its own.
class FrontierExplorerNode {
 public:
  static constexpr unsigned kCallbackThreads = 1;

  FrontierExplorerNode(ros::NodeHandle nh, ros::NodeHandle private_nh)
      : config_(loadConfig<config::FrontierExplorerNodeConfig>(private_nh)),
        explorer_(config_.explorer),
        diagnostics_(nh, "frontier_explorer"),
        saver_(nh, config_.save_folder),
        move_base_(nh, names::kMoveBase, false),
        status_publisher_(nh.advertise<ExplorationStatus>(names::kExplorationStatus, 1, true)),
        marker_publisher_(
            nh.advertise<visualization_msgs::MarkerArray>(names::kExplorationMarkers, 1, true)) {
    subscribe(nh);
    serve(private_nh);
    if (config_.auto_start) {
      (void)explorer_.start();
    }
    publishStatus();
    timer_ = nh.createTimer(ros::Duration(1.0 / config_.update_rate),
                            &FrontierExplorerNode::onTimer, this);
  }

  void shutdown() {
    if (explorer_.goal() && move_base_.isServerConnected()) {
      move_base_.cancelGoal();
    }
    saver_.finish();
  }

 private:
  void subscribe(ros::NodeHandle& nh) {
    subscribers_ = {nh.subscribe(names::kKeyframe, names::kKeyframeQueue,
                                 &FrontierExplorerNode::onKeyframe, this),
                    nh.subscribe(names::kPoseGraph, 1, &FrontierExplorerNode::onPoseGraph, this),
                    nh.subscribe(names::kMap, 1, &FrontierExplorerNode::onMap, this),
                    nh.subscribe(names::kBumper, 1, &FrontierExplorerNode::onBumper, this)};
  }

  void serve(ros::NodeHandle& private_nh) {
    const auto trigger = [&](const char* name, Reply (Explorer::*wish)()) {
      services_.push_back(
          private_nh.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>(
              name, [this, wish](auto& /*request*/, auto& response) {
                return answer((explorer_.*wish)(), response);
              }));
    };
    trigger("start", &Explorer::start);
    trigger("stop", &Explorer::stop);
    trigger("pause", &Explorer::pause);
    trigger("resume", &Explorer::resume);
    services_.push_back(private_nh.advertiseService<SetStrategy::Request, SetStrategy::Response>(
        "set_strategy", [this](auto& request, auto& response) {
          return answer(explorer_.setStrategy(request.strategy), response);
        }));
  }

  template <class Response>
  bool answer(const Reply& reply, Response& response) {
    response.success = reply.success;
    response.message = reply.message;
    ROS_INFO_STREAM(reply.message);
    update();
    return true;
  }

  void onKeyframe(const Keyframe::ConstPtr& message) {
    auto keyframe = keyframeFromRos(*message);
    if (keyframe.value) {
      news_.addKeyframe(message->run, std::move(*keyframe.value));
    } else {
      diagnostics_.reject(keyframe.fault);
    }
  }

  void onPoseGraph(const PoseGraph::ConstPtr& message) {
    auto poses = posesFromRos(*message);
    if (poses.value) {
      news_.setPoses(message->run, std::move(*poses.value));
    } else {
      diagnostics_.reject(poses.fault);
    }
  }

  void onMap(const nav_msgs::OccupancyGrid::ConstPtr& message) {
    auto map = gridFromRos(*message);
    if (!map || frameName(message->header.frame_id) != config_.map_frame) {
      diagnostics_.reject(map ? "map of another frame" : "map that makes no sense");
      return;
    }
    if (map->cells.empty()) {
      return;
    }
    diagnostics_.accept(message->header.stamp.toSec());
    map_ = std::make_shared<const grid::OccupancyGrid>(std::move(*map));
    const auto news = news_.take(message->header.stamp.toSec(), map_->geometry.resolution);
    std::vector<exploration::PlacedSweep> sweeps;
    for (const mapping::PlacedSweep& placed : news.keyframes) {
      sweeps.push_back({placed.sweep.get(), placed.T_map_base});
    }
    explorer_.showMap(map_, sweeps, news.motion ? &*news.motion : nullptr);
    publishMarkers();
  }

  void onBumper(const sensor_msgs::PointCloud2::ConstPtr& message) {
    const auto contacts =
        contactsOf(*message, config_.explorer.robot_radius, config_.base_frame, tf_buffer_);
    if (contacts.value) {
      explorer_.touch(*contacts.value);
    } else {
      diagnostics_.reject("no place of the bumper on the robot", contacts.problem);
    }
  }

  void onTimer(const ros::TimerEvent& /*event*/) {
    update();
    saver_.poll();
  }

  void update() {
    const ros::Time now = ros::Time::now();
    if (now.isZero()) {
      return;
    }
    obey(explorer_.update(now.toSec(), pose(now)));
    if (explorer_.phase() == Phase::kEnded && saved_phase_ != Phase::kEnded) {
      ROS_INFO_STREAM("The exploration has ended (" << toString(explorer_.ending()) << "). "
                                                    << explorer_.reason());
      saver_.save();
    }
    saved_phase_ = explorer_.phase();
    publishStatus();
  }

  /// The pose of the robot; none, and waiting_ says why, where tf or the driver is missing: then
  /// nothing changes until they are there.
  std::optional<geometry::Pose2> pose(const ros::Time& now) {
    waiting_.clear();
    if (!move_base_.isServerConnected()) {
      waiting_ = "It waits for move_base.";
      return std::nullopt;
    }
    if (!map_) {
      waiting_ = "It waits for a map.";
      return std::nullopt;
    }
    const auto answer = lookupOdometry(tf_buffer_, config_.map_frame, config_.base_frame);
    if (!answer.value || now.toSec() - answer.value->stamp > kPoseAge) {
      waiting_ = "It waits for the robot's pose.";
      diagnostics_.reject("no pose", answer.problem);
      return std::nullopt;
    }
    return answer.value->pose;
  }

  void obey(const Order& order) {
    if (order.kind == Order::Kind::kCancel) {
      move_base_.cancelGoal();
    } else if (order.kind == Order::Kind::kGo) {
      move_base_msgs::MoveBaseGoal goal;
      goal.target_pose.header.frame_id = config_.map_frame;
      goal.target_pose.header.stamp = ros::Time::now();
      goal.target_pose.pose = poseToRos(order.goal.T_map_base);
      const std::uint64_t id = order.goal.id;
      move_base_.sendGoal(goal, [this, id](const actionlib::SimpleClientGoalState& state,
                                           const move_base_msgs::MoveBaseResultConstPtr&) {
        const bool reached = state == actionlib::SimpleClientGoalState::SUCCEEDED;
        if (!reached) {
          ROS_INFO_STREAM("Goal " << id << " was not reached: " << state.getText());
        }
        explorer_.goalEnded(id, reached);
      });
    }
    if (order.kind != Order::Kind::kKeepOn) {
      publishMarkers();
    }
  }

  [[nodiscard]] std_msgs::Header header() const {
    std_msgs::Header header;
    header.frame_id = config_.map_frame;
    header.stamp = ros::Time::now();
    return header;
  }

  void publishMarkers() {
    if (map_ && marker_publisher_.getNumSubscribers() > 0) {
      marker_publisher_.publish(
          explorationMarkers(explorer_, exploration::MapView(*map_), header()));
    }
  }

  /// Once a second, and when something has changed.
  void publishStatus() {
    ExplorationStatus status;
    status.header = header();
    status.phase = toString(explorer_.phase());
    status.ending =
        explorer_.ending() == exploration::Ending::kNone ? "" : toString(explorer_.ending());
    status.reason = explorer_.reason().empty() ? waiting_ : explorer_.reason();
    status.strategy = explorer_.strategy();
    status.share = explorer_.progress().share;
    status.distance = explorer_.progress().distance;
    status.time = explorer_.progress().time;
    status.frontiers = static_cast<std::uint32_t>(explorer_.progress().frontiers);
    status.set_aside = static_cast<std::uint32_t>(explorer_.setAside().size());
    status.goals = static_cast<std::uint32_t>(explorer_.progress().goals);
    const double age = (status.header.stamp - published_.header.stamp).toSec();
    if (status.phase == published_.phase && status.reason == published_.reason &&
        status.goals == published_.goals && status.strategy == published_.strategy && age >= 0.0 &&
        age < kStatusInterval) {
      return;
    }
    published_ = status;
    status_publisher_.publish(status);
    diagnostics_.setHealth(explorer_.ending() == exploration::Ending::kStuck
                               ? diagnostic_msgs::DiagnosticStatus::WARN
                               : diagnostic_msgs::DiagnosticStatus::OK,
                           status.phase + (status.reason.empty() ? "" : ": " + status.reason));
  }

  const config::FrontierExplorerNodeConfig config_;
  Explorer explorer_;
  MapNews news_;
  std::shared_ptr<const grid::OccupancyGrid> map_;
  std::string waiting_;
  Phase saved_phase_{Phase::kIdle};  ///< at the last look
  ExplorationStatus published_;
  Diagnostics diagnostics_;
  RunSaver saver_;
  tf2_ros::Buffer tf_buffer_;
  tf2_ros::TransformListener tf_listener_{tf_buffer_};
  actionlib::SimpleActionClient<move_base_msgs::MoveBaseAction> move_base_;
  ros::Publisher status_publisher_;
  ros::Publisher marker_publisher_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  ros::Timer timer_;
};

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  return omega_slam::runNode<omega_slam::FrontierExplorerNode>(argc, argv, "frontier_explorer");
}

#include <fmt/format.h>
#include <omega_slam/ConstraintArray.h>
#include <omega_slam/Keyframe.h>
#include <omega_slam/PoseGraph.h>
#include <omega_slam/SaveGraph.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/transform_broadcaster.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <string>

#include "nodes/common/conversions.h"
#include "nodes/common/diagnostics.h"
#include "nodes/common/graph_pictures.h"
#include "nodes/common/graph_worker.h"
#include "nodes/common/names.h"
#include "nodes/common/node_config.h"
#include "nodes/common/node_runner.h"
#include "nodes/common/slam_conversions.h"
#include "omega_slam/graph/graph_file.h"
#include "omega_slam/grid/atomic_file.h"

namespace omega_slam {
namespace {

/// [s] A clock that goes back by less is one that wavers.
constexpr double kTimeJump = 1.0;

/// Looks at simulated time for each transform. (A ros::Timer looks a thousand times a second, which
/// is most of what this node would cost.)
constexpr double kTicks = 2.0;
/// In the wall's time that lies between two transforms: up to so many times as fast may simulated
/// time run.
constexpr double kMostTicks = 5.0;
constexpr double kPaceTime = 1.0;  // [s] of the wall's time, over which the speed is measured

/// Keyframes and constraints in; the solved graph, the trajectory and map -> odom out. The graph
/// lives in a GraphWorker; callbacks only convert and hand over, so that a long solve delays none.
class GraphSlamNode {
 public:
  static constexpr unsigned kCallbackThreads = 2;  // saving a graph must not hold up map -> odom

  GraphSlamNode(ros::NodeHandle nh, ros::NodeHandle private_nh)
      : config_(loadConfig<config::GraphSlamNodeConfig>(private_nh)),
        diagnostics_(nh, "graph_slam"),
        graph_publisher_(nh.advertise<PoseGraph>(names::kPoseGraph, 1, true)),
        pictures_(nh, config_.map_frame),
        worker_(config_.back_end, diagnostics_, [this](const GraphSnapshotPtr& snapshot) {
          publish(*snapshot);
          pictures_.show(snapshot);
        }) {
    diagnostics_.setHealth(diagnostic_msgs::DiagnosticStatus::OK, "waiting for keyframes");
    keyframe_subscriber_ =
        nh.subscribe(names::kKeyframe, names::kKeyframeQueue, &GraphSlamNode::onKeyframe, this);
    constraint_subscriber_ = nh.subscribe(names::kConstraints, names::kKeyframeQueue,
                                          &GraphSlamNode::onConstraints, this);
    save_service_ =
        private_nh.advertiseService(names::kSaveGraphService, &GraphSlamNode::onSave, this);
    reset_service_ =
        private_nh.advertiseService(names::kResetService, &GraphSlamNode::onReset, this);
    transform_timer_ =
        nh.createWallTimer(transformPeriod(ros::Time::isSimTime() ? kMostTicks : 1.0),
                           &GraphSlamNode::publishTransform, this);
  }

  void shutdown() { worker_.stop(); }

 private:
  void onKeyframe(const Keyframe::ConstPtr& message) {
    const auto keyframe = keyframeFromRos(*message);
    if (!keyframe.value) {
      diagnostics_.reject(keyframe.fault);
      return;
    }
    worker_.add(KeyframeArrival{message->run, message->id, message->header.stamp,
                                keyframe.value->T_odom_base});
  }

  void onConstraints(const ConstraintArray::ConstPtr& message) {
    ConstraintArrival arrival;
    arrival.run = message->run;
    for (const Constraint& constraint : message->constraints) {
      auto read = constraintFromRos(constraint);
      if (read.value) {
        arrival.constraints.push_back(*read.value);
      } else {
        diagnostics_.reject(read.fault);
      }
    }
    worker_.add(std::move(arrival));
  }

  /// In the worker's thread.
  void publish(const GraphSnapshot& snapshot) {
    PoseGraph message = poseGraphToRos(snapshot.graph, snapshot.stamps, snapshot.beliefs);
    message.header.frame_id = config_.map_frame;
    message.header.stamp = snapshot.newest();
    message.run = snapshot.run;
    message.chi_square = snapshot.chi_square;
    graph_publisher_.publish(message);
  }

  /// @param ticks for a transform
  [[nodiscard]] ros::WallDuration transformPeriod(double ticks) const {
    return ros::WallDuration(1.0 / (ticks * config_.transform_rate));
  }

  /// Ticks with simulated time, which may run faster than the wall's.
  void keepPace(const ros::Time& now) {
    const ros::SteadyTime wall = ros::SteadyTime::now();
    const double elapsed = (wall - paced_wall_).toSec();
    if (elapsed < kPaceTime) {
      return;
    }
    const double speed = (now - paced_now_).toSec() / elapsed;
    transform_timer_.setPeriod(transformPeriod(std::clamp(kTicks * speed, kTicks, kMostTicks)));
    paced_wall_ = wall;
    paced_now_ = now;
  }

  void publishTransform(const ros::WallTimerEvent&) {
    const std::lock_guard<std::mutex> lock(transform_mutex_);
    const ros::Time now = ros::Time::now();
    if (ros::Time::isSimTime()) {
      keepPace(now);
    }
    const auto snapshot = worker_.snapshot();
    if (now.toSec() < last_now_.toSec() - kTimeJump) {
      ROS_INFO_STREAM("Time jumped back to " << now << ": map -> odom waits for a new run.");
      last_stamp_ = ros::Time();
      ended_run_ = snapshot && isAhead(*snapshot, now) ? snapshot->run : 0;
    }
    last_now_ = now;
    const ros::Time stamp = now + ros::Duration(config_.transform_tolerance);
    // While simulated time stands still tf has this transform already, and warns of a second one.
    const double least = ros::Time::isSimTime() ? 0.9 / config_.transform_rate : 0.0;
    if (!snapshot || snapshot->graph.poses.empty() || snapshot->run == ended_run_ || now.isZero() ||
        stamp <= last_stamp_ + ros::Duration(least)) {
      return;
    }
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = stamp;
    transform.header.frame_id = config_.map_frame;
    transform.child_frame_id = config_.odom_frame;
    transform.transform = transformToRos(snapshot->T_map_odom);
    broadcaster_.sendTransform(transform);
    last_stamp_ = stamp;
  }

  /// Whether the graph is of a time that is still to come: it was built before the clock was set
  /// back.
  [[nodiscard]] static bool isAhead(const GraphSnapshot& snapshot, const ros::Time& now) {
    return snapshot.newest().toSec() > now.toSec() + kTimeJump;
  }

  bool onSave(SaveGraph::Request& request, SaveGraph::Response& response) {
    const auto snapshot = worker_.snapshot();
    if (!snapshot || snapshot->graph.poses.empty()) {
      response.message = "There is no graph to save: no keyframe has come yet.";
      return true;
    }
    const auto path = std::filesystem::absolute(request.path.empty() ? "graph.g2o" : request.path);
    const std::string failure = grid::writeFileAtomically(path, graph::toG2o(snapshot->graph));
    response.success = failure.empty();
    response.message = failure.empty()
                           ? fmt::format("Saved {} keyframes and {} constraints to {}.",
                                         snapshot->graph.poses.size(),
                                         snapshot->graph.constraints.size(), path.string())
                           : failure;
    if (response.success) {
      response.paths.push_back(path.string());
    }
    return true;
  }

  bool onReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    const auto snapshot = worker_.snapshot();
    const std::size_t keyframes = snapshot ? snapshot->graph.poses.size() : 0;
    worker_.reset();
    response.success = true;
    response.message =
        fmt::format("Forgot {} keyframes; a new run begins with the next scan.", keyframes);
    ROS_INFO_STREAM(response.message);
    return true;
  }

  config::GraphSlamNodeConfig config_;
  Diagnostics diagnostics_;
  ros::Publisher graph_publisher_;
  GraphPictures pictures_;
  tf2_ros::TransformBroadcaster broadcaster_;
  std::mutex transform_mutex_;  ///< guards the next five
  ros::SteadyTime paced_wall_;  ///< when the pace was set last,
  ros::Time paced_now_;         ///< and what simulated time it was
  ros::Time last_now_;
  ros::Time last_stamp_;        ///< of map -> odom
  std::uint64_t ended_run_{0};  ///< by the clock; 0: none
  GraphWorker worker_;          ///< after all that it publishes by
  ros::Subscriber keyframe_subscriber_;
  ros::Subscriber constraint_subscriber_;
  ros::ServiceServer save_service_;
  ros::ServiceServer reset_service_;
  ros::WallTimer transform_timer_;
};

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  return omega_slam::runNode<omega_slam::GraphSlamNode>(argc, argv, "graph_slam");
}

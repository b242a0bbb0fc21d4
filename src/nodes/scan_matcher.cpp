#include <fmt/format.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <omega_slam/PoseGraph.h>
#include <omega_slam/Tracking.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "nodes/common/conversions.h"
#include "nodes/common/diagnostics.h"
#include "nodes/common/loop_search.h"
#include "nodes/common/names.h"
#include "nodes/common/node_config.h"
#include "nodes/common/node_runner.h"
#include "nodes/common/odometry_track.h"
#include "nodes/common/run_publisher.h"
#include "nodes/common/scan_queue.h"
#include "nodes/common/sequence_gaps.h"
#include "nodes/common/slam_conversions.h"
#include "nodes/common/tf_lookup.h"
#include "omega_slam/sensing/frozen_laser.h"
#include "omega_slam/sensing/scan_intake.h"
#include "omega_slam/sensing/sweep_duration.h"
#include "omega_slam/slam/front_end.h"

namespace omega_slam {
namespace {

constexpr std::size_t kWaitingScans = 100;  // ten seconds of a Hokuyo
/// [Hz] of wall time, at which scans are looked at that wait for what no message here announces:
/// the laser's pose, and the end of their patience.
constexpr double kServiceRate = 5.0;
/// A thread of tf's own would wake a hundred times a second.
constexpr bool kOwnThread = false;
constexpr double kNever = -std::numeric_limits<double>::infinity();

/// Scans and odometry in, keyframes and constraints out. Callbacks run in one thread, which owns
/// everything but the search for loops: that has a thread of its own, so that scans never wait for
/// it.
class ScanMatcherNode {
 public:
  static constexpr unsigned kCallbackThreads = 1;

  ScanMatcherNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh)
      : config_(loadConfig<config::ScanMatcherNodeConfig>(private_nh)),
        intake_(config_.intake),
        front_end_(config_.front_end),
        queue_(config_.odometry_wait, kWaitingScans),
        tf_listener_(tf_buffer_, nh, kOwnThread),
        diagnostics_(nh, "scan_matcher"),
        publisher_(nh),
        tracking_publisher_(nh.advertise<Tracking>(names::kTracking, names::kOdometryQueue)),
        pose_publisher_(nh.advertise<geometry_msgs::PoseWithCovarianceStamped>(names::kTrackedPose,
                                                                               names::kScanQueue)),
        lost_publisher_(nh.advertise<std_msgs::Bool>(names::kLost, 1, true)),
        loops_(config_.loops, publisher_.run(), [this](const auto& constraints, std::uint64_t run) {
          publisher_.publish(constraints, run);
          reportLoops();
        }) {
    diagnostics_.setHealth(diagnostic_msgs::DiagnosticStatus::OK, "waiting for scans");
    publishLost(false);
    scan_subscriber_ =
        nh.subscribe(names::kScan, names::kScanQueue, &ScanMatcherNode::onScan, this);
    prediction_subscriber_ = nh.subscribe(names::kPrediction, names::kOdometryQueue,
                                          &ScanMatcherNode::onPrediction, this);
    graph_subscriber_ = nh.subscribe(names::kPoseGraph, 1, &ScanMatcherNode::onPoseGraph, this);
    timer_ = nh.createWallTimer(ros::WallDuration(1.0 / kServiceRate),
                                [this](const ros::WallTimerEvent&) { serveScans(); });
  }

  void shutdown() { loops_.stop(); }

 private:
  void onScan(const ros::MessageEvent<const sensor_msgs::LaserScan>& event) {
    const sensor_msgs::LaserScan::ConstPtr message = event.getConstMessage();
    const auto lost = scan_gaps_.lostBefore(event.getPublisherName(), message->header.seq);
    for (std::uint32_t scan = 0; scan < lost; ++scan) {
      diagnostics_.reject("scan lost on its way", "This node or the machine is too busy.");
    }
    WaitingScan waiting{message, scanFromRos(*message), 0.0, ros::SteadyTime::now().toSec()};
    waiting.end = waiting.scan.stamp + sensing::sweepDuration(waiting.scan);
    if (queue_.push(std::move(waiting))) {
      diagnostics_.reject("too many scans wait");
    }
    serveScans();
  }

  void onPrediction(const geometry_msgs::PoseWithCovarianceStamped::ConstPtr& message) {
    const auto pose = poseFromRos(message->pose.pose);
    const auto covariance = covarianceFromRos(message->pose.covariance);
    if (!pose || !covariance) {
      diagnostics_.reject("prediction is not finite");
      return;
    }
    switch (track_.add({message->header.stamp.toSec(), *pose, *covariance})) {
      case motion::OdometryVerdict::kTimeJumpedBack:
        ROS_INFO_STREAM("Time jumped back to " << message->header.stamp << ".");
        tf_buffer_.clear();
        queue_.clear();
        newest_scan_ = kNever;
        beginRun();
        break;
      case motion::OdometryVerdict::kAccepted:
        break;
      default:
        diagnostics_.reject("prediction out of order");
        return;
    }
    serveScans();
  }

  void onPoseGraph(const PoseGraph::ConstPtr& message) {
    if (message->run != publisher_.run()) {
      diagnostics_.reject("pose graph of another run");
      return;
    }
    auto graph = poseGraphFromRos(*message);
    if (!graph.value) {
      diagnostics_.reject(graph.fault);
    } else if (graph.value->poses.empty()) {
      ROS_INFO("The graph was reset.");
      beginRun();
    } else {
      front_end_.believe(*graph.value);
      loops_.setGraph(std::move(*graph.value));
      reportHealth();
    }
  }

  void beginRun() {
    front_end_.reset();
    loops_.reset(publisher_.beginRun());
    diagnostics_.rearm();
    publishLost(false);
    ROS_INFO("A new run begins: the next scan is keyframe 0.");
  }

  void serveScans() {
    while (!queue_.empty()) {
      const WaitingScan& oldest = queue_.front();
      if (const std::string reason = hopelessness(oldest); !reason.empty()) {
        diagnostics_.reject(reason);
        queue_.pop();
        continue;
      }
      const auto mount = mountOf(*oldest.message);
      if (!mount.value || !track_.covers(oldest.scan.stamp, oldest.end)) {
        break;
      }
      serve(queue_.pop(), *mount.value);
    }
    for (const WaitingScan& scan : queue_.giveUp(track_.newest(), ros::SteadyTime::now().toSec())) {
      explainWaiting(scan);
    }
  }

  /// Why waiting will not help a scan; empty if it may.
  [[nodiscard]] std::string hopelessness(const WaitingScan& waiting) const {
    if (waiting.scan.stamp <= newest_scan_) {
      return "scan is not newer than the one before";
    }
    return track_.isTooOld(waiting.scan.stamp) ? "scan is older than the odometry" : "";
  }

  [[nodiscard]] TfAnswer<sensing::LaserMount> mountOf(const sensor_msgs::LaserScan& scan) const {
    if (const auto& pose = config_.laser_pose; !pose.empty()) {
      return {sensing::LaserMount{{pose[0], pose[1], pose[2]}, false}, {}};
    }
    return lookupLaserMount(tf_buffer_, config_.base_frame, scan.header.frame_id,
                            scan.header.stamp);
  }

  void serve(const WaitingScan& waiting, const sensing::LaserMount& mount) {
    const sensing::LaserScan& scan = waiting.scan;
    const auto taken =
        intake_.process(scan, mount, track_.motionDuring(scan.stamp, waiting.end - scan.stamp));
    for (const std::string& repair : taken.repairs) {
      diagnostics_.repair(repair);
    }
    if (!taken.sweep) {
      diagnostics_.reject(taken.rejection);
      return;
    }
    const double stamp = taken.sweep->stamp;
    const geometry::Pose2 T_odom_base = track_.at(scan.stamp)->T_odom_base * taken.T_start_sweep;
    const motion::Prediction prediction{stamp, T_odom_base, track_.at(stamp)->covariance};
    if (frozen_laser_.repeats(scan.ranges, prediction.T_odom_base)) {
      diagnostics_.reject(sensing::FrozenLaser::kRejection);
      return;
    }
    newest_scan_ = scan.stamp;
    diagnostics_.accept(scan.stamp);
    std_msgs::Header header = waiting.message->header;
    header.stamp += ros::Duration(stamp - scan.stamp);
    publish(front_end_.process(*taken.sweep, prediction), header);
  }

  void publish(const slam::FrontEndResult& result, std_msgs::Header header) {
    publishPose(result.belief, header);
    for (const std::string& remark : result.remarks) {
      diagnostics_.repair(remark);
    }
    if (result.is_lost != is_lost_) {
      publishLost(result.is_lost);
      reportHealth();
    }
    if (result.match) {
      ++(result.match_trusted ? matches_trusted_ : matches_untrusted_);
      diagnostics_.set("confidence of the last match", result.match->confidence);
    }
    header.frame_id = config_.base_frame;
    tracking_publisher_.publish(trackingToRos(result, header, publisher_.run()));
    if (!result.keyframe) {
      return;
    }
    publisher_.publish(*result.keyframe, header, result.constraints);
    loops_.addKeyframe(result.keyframe);
    reportHealth();
  }

  /// Said once when it changes, and to whoever comes later.
  void publishLost(bool is_lost) {
    if (is_lost) {
      ROS_WARN(
          "Lost: what the laser sees contradicts the map. No keyframes until a place is known.");
    } else if (is_lost_) {
      ROS_INFO("No longer lost.");
    }
    is_lost_ = is_lost;
    std_msgs::Bool message;
    message.data = static_cast<std_msgs::Bool::_data_type>(is_lost);
    lost_publisher_.publish(message);
  }

  void publishPose(const slam::Belief& belief, std_msgs::Header header) {
    geometry_msgs::PoseWithCovarianceStamped message;
    message.header = std::move(header);
    message.header.frame_id = config_.map_frame;
    message.pose.pose = poseToRos(belief.pose);
    message.pose.covariance = covarianceToRos(belief.covariance);
    pose_publisher_.publish(message);
  }

  void explainWaiting(const WaitingScan& waiting) {
    if (track_.covers(waiting.scan.stamp, waiting.end)) {
      diagnostics_.reject("no usable pose of the laser",
                          mountOf(*waiting.message).problem +
                              " The robot's frame is named by base_frame; laser_pose does without "
                              "tf.");
      return;
    }
    diagnostics_.reject(
        "no odometry for the scan",
        fmt::format(
            "Nothing on '{}' covers the time {:.6f} to {:.6f} of the scan, though it waited "
            "for odometry_wait.",
            prediction_subscriber_.getTopic(), waiting.scan.stamp, waiting.end));
  }

  void reportHealth() {
    if (is_lost_) {
      diagnostics_.setHealth(diagnostic_msgs::DiagnosticStatus::ERROR, "lost");
    } else {
      diagnostics_.setHealth(diagnostic_msgs::DiagnosticStatus::OK, "matching");
    }
    diagnostics_.set("keyframes", static_cast<double>(publisher_.keyframes()));
    diagnostics_.set("matches trusted", static_cast<double>(matches_trusted_));
    diagnostics_.set("matches not trusted", static_cast<double>(matches_untrusted_));
    const std::string faults = describe(front_end_.odometryFaults());
    diagnostics_.set("faults of the odometry", faults.empty() ? "none" : faults);
    reportLoops();
  }

  /// In any thread.
  void reportLoops() {
    diagnostics_.set("keyframes searched for loops", static_cast<double>(loops_.searched()));
    diagnostics_.set("loops", static_cast<double>(loops_.found()));
  }

  config::ScanMatcherNodeConfig config_;
  sensing::ScanIntake intake_;
  sensing::FrozenLaser frozen_laser_;
  slam::FrontEnd front_end_;
  OdometryTrack track_;
  SequenceGaps scan_gaps_;
  ScanQueue queue_;
  double newest_scan_{kNever};  ///< [s] stamp of the newest scan served
  std::size_t matches_trusted_{0};
  std::size_t matches_untrusted_{0};
  bool is_lost_{false};
  tf2_ros::Buffer tf_buffer_;
  tf2_ros::TransformListener tf_listener_;
  Diagnostics diagnostics_;
  RunPublisher publisher_;
  ros::Publisher tracking_publisher_;
  ros::Publisher pose_publisher_;
  ros::Publisher lost_publisher_;
  LoopSearch loops_;
  ros::Subscriber scan_subscriber_;
  ros::Subscriber prediction_subscriber_;
  ros::Subscriber graph_subscriber_;
  ros::WallTimer timer_;
};

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  return omega_slam::runNode<omega_slam::ScanMatcherNode>(argc, argv, "scan_matcher");
}

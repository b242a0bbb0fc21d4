#include <diagnostic_msgs/DiagnosticArray.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <omega_slam/ExplorationStatus.h>
#include <omega_slam/Keyframe.h>
#include <omega_slam/PoseGraph.h>
#include <omega_slam/Tracking.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/String.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "nodes/common/conversions.h"
#include "nodes/common/exploration_line.h"
#include "nodes/common/names.h"
#include "nodes/common/node_config.h"
#include "nodes/common/node_runner.h"
#include "nodes/common/run_recorder_accounts.h"
#include "nodes/common/run_recorder_config.h"
#include "nodes/common/run_recorder_delays.h"
#include "nodes/common/run_recorder_end.h"
#include "nodes/common/run_recorder_record.h"
#include "nodes/common/run_recorder_report.h"
#include "nodes/common/run_recorder_results.h"
#include "nodes/common/run_recorder_status.h"
#include "nodes/common/slam_conversions.h"
#include "nodes/common/tf_lookup.h"
#include "omega_slam/evaluation/resemblance.h"

namespace omega_slam {
namespace {

constexpr double kStatusPeriod = 0.2;  ///< [s] of wall time between looks at the run
constexpr double kClockJump = 1.0;     ///< [s] a scan that much too old means a run from its start

// Steps whose delays are measured.
constexpr char kToKeyframe[] = "scan to keyframe";
constexpr char kToGraph[] = "keyframe to pose graph";
constexpr char kToMap[] = "keyframe to map";

double wallTime() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Watches a simulated run: shows how it goes, saves what came of it, and ends with it.
class RunRecorder {
 public:
  static constexpr unsigned kCallbackThreads = 1;  // nothing here is shared between threads

  RunRecorder(ros::NodeHandle nh, const ros::NodeHandle& private_nh);

  /// Saves. @throws std::runtime_error if something could not be saved
  void shutdown();

 private:
  void onOdometry(const nav_msgs::Odometry::ConstPtr& message);
  void onTruth(const nav_msgs::Odometry::ConstPtr& message);
  void onScan(const sensor_msgs::LaserScan::ConstPtr& message);
  void onTracking(const Tracking::ConstPtr& message);
  void onKeyframe(const Keyframe::ConstPtr& message);
  void onPoseGraph(const PoseGraph::ConstPtr& message);
  void onMap(const nav_msgs::OccupancyGrid::ConstPtr& message);
  void onTick(const ros::WallTimerEvent& event);

  void subscribe(ros::NodeHandle& nh);
  [[nodiscard]] RunProgress progress() const;
  [[nodiscard]] RunFigures figures();
  [[nodiscard]] std::optional<double> shareSeen();
  [[nodiscard]] std::optional<double> trackingError();

  RunRecorderConfig config_;
  std::optional<TrueWorld> world_;
  RunRecord record_;
  RunEnd end_;
  StatusLine status_line_;
  std::string route_status_;
  RunAccounts accounts_;
  RunDelays delays_;
  std::optional<double> newest_scan_;  ///< [s] stamp
  std::optional<double> start_;        ///< [s] wall time of the first scan
  std::optional<double> share_seen_;   ///< of the map at `share_stamp_`
  double share_stamp_{-1.0};
  std::optional<geometry::StampedPose2> tracked_;  ///< `T_map_base` at the last look
  tf2_ros::Buffer tf_buffer_;
  tf2_ros::TransformListener tf_listener_{tf_buffer_};
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer timer_;
};

RunRecorder::RunRecorder(ros::NodeHandle nh, const ros::NodeHandle& private_nh)
    : config_(loadConfig<RunRecorderConfig>(private_nh, ros::console::levels::Debug)),
      end_(config_.end),
      status_line_(isatty(STDOUT_FILENO) == 1, config_.status_interval) {
  if (!config_.world.empty()) {
    world_ = loadTrueWorld(config_.world);
  }
  subscribe(nh);
  timer_ = nh.createWallTimer(ros::WallDuration(kStatusPeriod), &RunRecorder::onTick, this);
}

void RunRecorder::subscribe(ros::NodeHandle& nh) {
  // Nothing may be lost while results are computed, so queues hold more than a second at any speed.
  constexpr unsigned kQueue = names::kKeyframeQueue;
  subscribers_ = {
      nh.subscribe(names::kOdometry, kQueue, &RunRecorder::onOdometry, this),
      nh.subscribe(names::kGroundTruth, kQueue, &RunRecorder::onTruth, this),
      nh.subscribe(names::kScan, kQueue, &RunRecorder::onScan, this),
      nh.subscribe(names::kTracking, kQueue, &RunRecorder::onTracking, this),
      nh.subscribe(names::kKeyframe, kQueue, &RunRecorder::onKeyframe, this),
      nh.subscribe(names::kPoseGraph, 1, &RunRecorder::onPoseGraph, this),
      nh.subscribe(names::kMap, 1, &RunRecorder::onMap, this),
      nh.subscribe<diagnostic_msgs::DiagnosticArray>(
          names::kDiagnostics, kQueue, [this](const auto& message) { accounts_.update(*message); }),
      nh.subscribe<std_msgs::String>(
          names::kRouteStatus, 1, [this](const auto& message) { route_status_ = message->data; }),
      nh.subscribe<ExplorationStatus>(names::kExplorationStatus, 1, [this](const auto& message) {
        route_status_ = explorationLine(*message);
      })};
}

void RunRecorder::onOdometry(const nav_msgs::Odometry::ConstPtr& message) {
  if (const auto pose = poseFromRos(message->pose.pose)) {
    record_.addOdometry(message->header.stamp.toSec(), *pose);
  }
}

void RunRecorder::onTruth(const nav_msgs::Odometry::ConstPtr& message) {
  if (const auto pose = poseFromRos(message->pose.pose)) {
    record_.addTruth(message->header.stamp.toSec(), *pose);
  }
}

void RunRecorder::onScan(const sensor_msgs::LaserScan::ConstPtr& message) {
  const double stamp = message->header.stamp.toSec();
  // Compared with scans alone: those of one publisher come in their order, however late.
  if (newest_scan_ && stamp < *newest_scan_ - kClockJump) {
    ROS_INFO("Time has jumped back from %.2f s to %.2f s: what was recorded is forgotten.",
             *newest_scan_, stamp);
    record_.clear();
    delays_ = RunDelays();
    start_.reset();
  }
  newest_scan_ = stamp;
  start_ = start_.value_or(wallTime());
  record_.addScan(stamp);
  delays_.begin(kToKeyframe, message->header.stamp.toNSec(), wallTime());
}

void RunRecorder::onTracking(const Tracking::ConstPtr& message) {
  const auto track = trackingFromRos(*message);
  if (!track.value) {
    ROS_WARN_THROTTLE(5.0, "A tracked scan was not recorded: %s.", track.fault.c_str());
    return;
  }
  record_.addTrack(message->run, *track.value);
}

void RunRecorder::onKeyframe(const Keyframe::ConstPtr& message) {
  const std::uint64_t stamp = message->header.stamp.toNSec();
  record_.addKeyframe(message->id, message->header.stamp.toSec());
  delays_.end(kToKeyframe, stamp, wallTime());
  delays_.begin(kToGraph, stamp, wallTime());
  delays_.begin(kToMap, stamp, wallTime());
}

void RunRecorder::onPoseGraph(const PoseGraph::ConstPtr& message) {
  auto reading = poseGraphFromRos(*message);
  auto beliefs = beliefsFromRos(*message);
  if (!reading.value || !beliefs.value) {
    const std::string& fault = reading.value ? beliefs.fault : reading.fault;
    ROS_WARN_THROTTLE(5.0, "A pose graph was not recorded: %s.", fault.c_str());
    return;
  }
  std::vector<double> stamps;
  stamps.reserve(message->stamps.size());
  for (const ros::Time& stamp : message->stamps) {
    stamps.push_back(stamp.toSec());
  }
  record_.setGraph(std::move(*reading.value), std::move(stamps), std::move(*beliefs.value));
  delays_.end(kToGraph, message->header.stamp.toNSec(), wallTime());
}

void RunRecorder::onMap(const nav_msgs::OccupancyGrid::ConstPtr& message) {
  auto map = gridFromRos(*message);
  if (!map) {
    ROS_WARN_THROTTLE(5.0, "A map was not recorded: its size, origin or values make no sense.");
    return;
  }
  record_.setMap(std::move(*map), message->header.stamp.toSec());
  delays_.end(kToMap, message->header.stamp.toNSec(), wallTime());
}

void RunRecorder::onTick(const ros::WallTimerEvent& /*event*/) {
  status_line_.show(formatStatus(figures()), wallTime());
  if (end_.update(progress()) == RunEnd::Phase::kOver) {
    ros::requestShutdown();
  }
}

RunProgress RunRecorder::progress() const {
  RunProgress progress;
  progress.time = record_.newest();
  progress.elapsed = record_.elapsed();
  progress.wall_time = wallTime();
  progress.route_status = route_status_;
  progress.keyframes = record_.keyframes();
  progress.graph_poses = record_.graph().poses.size();
  progress.graph_stamp = record_.graphStamps().empty() ? 0.0 : record_.graphStamps().back();
  progress.map_stamp = record_.mapStamp();
  return progress;
}

RunFigures RunRecorder::figures() {
  RunFigures figures;
  figures.elapsed = record_.elapsed();
  figures.distance = record_.distance();
  figures.keyframes = record_.keyframes();
  figures.loops = record_.loops();
  figures.share_seen = shareSeen();
  figures.pose_error = trackingError();
  figures.phase = end_.reason().empty() ? route_status_ : end_.reason();
  return figures;
}

std::optional<double> RunRecorder::shareSeen() {
  const auto T_world_map = record_.worldFromMap();
  if (!world_ || !T_world_map || record_.map().cells.empty()) {
    return std::nullopt;
  }
  if (share_stamp_ != record_.mapStamp()) {
    share_seen_ = evaluation::compareMaps(record_.map(), world_->map, {*T_world_map, world_->start})
                      .coverage();
    share_stamp_ = record_.mapStamp();
  }
  return share_seen_;
}

std::optional<double> RunRecorder::trackingError() {
  // What was tracked at the last look: by now the truth of that moment has arrived.
  const auto error = tracked_ ? record_.poseError(*tracked_) : std::nullopt;
  tracked_ = lookupOdometry(tf_buffer_, config_.map_frame, config_.base_frame).value;
  return error;
}

void RunRecorder::shutdown() {
  timer_.stop();
  status_line_.finish(formatStatus(figures()));
  RunEnding ending;
  ending.reason = end_.reason().empty() ? "interrupted" : end_.reason();
  ending.settled = end_.settled();
  ending.wall_time = start_ ? wallTime() - *start_ : 0.0;
  const evaluation::Report report = makeReport(record_, ending, accounts_, world_);
  auto timings = delays_.summarize();
  timings.push_back(evaluation::summarizeTimes("run", {ending.wall_time}));
  const auto faults = saveResults(config_.results, record_, report, timings);
  std::cout << formatClosing(report, ending) << std::flush;
  // rosconsole has nothing more to say after the shutdown: faults go to the terminal themselves.
  for (const std::string& fault : faults) {
    std::cerr << fault << std::endl;
  }
  if (!faults.empty()) {
    throw std::runtime_error("The results could not be saved completely.");
  }
  std::cout << "Results: " << std::filesystem::absolute(config_.results).string() << std::endl;
}

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  // roslaunch ends its nodes by SIGINT, others by SIGTERM: both save.
  std::signal(SIGTERM, [](int /*signal*/) { ros::requestShutdown(); });
  return omega_slam::runNode<omega_slam::RunRecorder>(argc, argv, "run_recorder");
}

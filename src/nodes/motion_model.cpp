#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/Odometry.h>
#include <omega_slam/Keyframe.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <cmath>
#include <cstdint>
#include <memory>

#include "nodes/common/conversions.h"
#include "nodes/common/diagnostics.h"
#include "nodes/common/names.h"
#include "nodes/common/node_config.h"
#include "nodes/common/node_runner.h"
#include "nodes/common/tf_lookup.h"
#include "omega_slam/motion/motion_predictor.h"
#include "omega_slam/motion/odometry_buffer.h"

namespace omega_slam {
namespace {

constexpr double kSamplesRate = 5.0;  // [Hz] of wall time: for the eye, not for machines

/// Odometry in; where the robot is by its wheels alone, and how sure that is, out. All callbacks
/// run in one thread, which owns everything here.
class MotionModelNode {
 public:
  static constexpr unsigned kCallbackThreads = 1;

  MotionModelNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh)
      : config_(loadConfig<config::MotionModelNodeConfig>(private_nh)),
        predictor_(config_.noise, config_.samples, static_cast<std::uint64_t>(config_.seed)),
        diagnostics_(nh, "motion_model") {
    prediction_publisher_ = nh.advertise<geometry_msgs::PoseWithCovarianceStamped>(
        names::kPrediction, names::kOdometryQueue);
    samples_publisher_ = nh.advertise<geometry_msgs::PoseArray>(names::kSamples, 1);
    keyframe_subscriber_ =
        nh.subscribe(names::kKeyframe, names::kKeyframeQueue, &MotionModelNode::onKeyframe, this);
    samples_timer_ = nh.createWallTimer(ros::WallDuration(1.0 / kSamplesRate),
                                        &MotionModelNode::publishSamples, this);
    listenToOdometry(nh);
  }

  void shutdown() {}

 private:
  void listenToOdometry(ros::NodeHandle& nh) {
    if (config_.odometry_source == "tf") {
      tf_listener_ = std::make_unique<tf2_ros::TransformListener>(tf_buffer_);
      tf_timer_ = nh.createTimer(ros::Duration(1.0 / config_.tf_rate),
                                 [this](const ros::TimerEvent&) { askTf(); });
      diagnostics_.setHealth(diagnostic_msgs::DiagnosticStatus::OK, "waiting for tf");
    } else {
      odometry_subscriber_ =
          nh.subscribe(names::kOdometry, names::kOdometryQueue, &MotionModelNode::onOdometry, this);
      diagnostics_.setHealth(diagnostic_msgs::DiagnosticStatus::OK, "waiting for odometry");
    }
  }

  void onOdometry(const nav_msgs::Odometry::ConstPtr& message) {
    const auto T_odom_base = poseFromRos(message->pose.pose);
    if (!T_odom_base) {
      diagnostics_.reject("odometry is not a finite pose");
      return;
    }
    const std::string frame = frameName(message->header.frame_id);
    follow(message->header.stamp, frame.empty() ? config_.odom_frame : frame, *T_odom_base);
  }

  void askTf() {
    const auto answer = lookupOdometry(tf_buffer_, config_.odom_frame, config_.base_frame);
    if (!answer.value) {
      diagnostics_.reject("no odometry on tf", answer.problem);
      return;
    }
    // Between two transforms tf gives the same one again: that is no fault.
    if (odometry_.empty() || answer.value->stamp != odometry_.newest()) {
      follow(timeToRos(answer.value->stamp), config_.odom_frame, answer.value->pose);
    }
  }

  void follow(const ros::Time& stamp, const std::string& frame,
              const geometry::Pose2& T_odom_base) {
    switch (odometry_.add(stamp.toSec(), T_odom_base)) {
      case motion::OdometryVerdict::kNotFinite:
        diagnostics_.reject("odometry is not a finite pose");
        return;
      case motion::OdometryVerdict::kDuplicate:
        diagnostics_.reject("odometry has the stamp of the one before");
        return;
      case motion::OdometryVerdict::kOutOfOrder:
        diagnostics_.reject("odometry out of order");
        return;
      case motion::OdometryVerdict::kTimeJumpedBack:
        reset(stamp);
        break;
      case motion::OdometryVerdict::kAccepted:
        break;
    }
    diagnostics_.accept(stamp.toSec());
    publishPrediction(stamp, frame, predictor_.predict(stamp.toSec(), T_odom_base));
  }

  void reset(const ros::Time& stamp) {
    ROS_INFO_STREAM("Time jumped back to " << stamp << ": the motion model begins anew.");
    tf_buffer_.clear();
    predictor_.reset();
    run_ = 0;
    diagnostics_.rearm();
  }

  void publishPrediction(const ros::Time& stamp, const std::string& frame,
                         const motion::Prediction& prediction) {
    geometry_msgs::PoseWithCovarianceStamped message;
    message.header.stamp = stamp;
    message.header.frame_id = frame;
    message.pose.pose = poseToRos(prediction.T_odom_base);
    message.pose.covariance = covarianceToRos(prediction.covariance);
    prediction_publisher_.publish(message);
    samples_header_ = message.header;
    diagnostics_.setHealth(diagnostic_msgs::DiagnosticStatus::OK, "predicting");
    diagnostics_.set("standard deviation of x since the keyframe [m]",
                     std::sqrt(prediction.covariance(0, 0)));
    diagnostics_.set("standard deviation of y since the keyframe [m]",
                     std::sqrt(prediction.covariance(1, 1)));
    diagnostics_.set("standard deviation of yaw since the keyframe [rad]",
                     std::sqrt(prediction.covariance(2, 2)));
  }

  /// The spread is counted from the newest keyframe: back to its odometry, then forward again along
  /// what has been driven since.
  void onKeyframe(const Keyframe::ConstPtr& message) {
    const auto T_odom_keyframe = poseFromRos(message->odometry);
    if (!T_odom_keyframe) {
      diagnostics_.reject("keyframe has numbers that are not finite");
      return;
    }
    if (message->run == run_ && message->id <= newest_keyframe_) {
      return;  // sent again to a subscriber that came late
    }
    run_ = message->run;
    newest_keyframe_ = message->id;
    predictor_.anchor(*T_odom_keyframe);
    for (const geometry::StampedPose2& pose : odometry_.poses()) {
      if (pose.stamp > message->header.stamp.toSec()) {
        (void)predictor_.predict(pose.stamp, pose.pose);
      }
    }
    diagnostics_.set("anchored at keyframe", static_cast<double>(newest_keyframe_));
  }

  void publishSamples(const ros::WallTimerEvent&) {
    if (odometry_.empty() || config_.samples == 0 || samples_publisher_.getNumSubscribers() == 0 ||
        samples_header_.stamp == last_samples_) {
      return;
    }
    geometry_msgs::PoseArray message;
    message.header = samples_header_;
    for (const geometry::Pose2& sample : predictor_.samples()) {
      message.poses.push_back(poseToRos(sample));
    }
    samples_publisher_.publish(message);
    last_samples_ = message.header.stamp;
  }

  config::MotionModelNodeConfig config_;
  motion::OdometryBuffer odometry_;
  motion::MotionPredictor predictor_;
  std::uint64_t run_{0};  ///< of the keyframe that the predictor is anchored at; 0: none
  std::uint32_t newest_keyframe_{0};
  std_msgs::Header samples_header_;  ///< of the newest prediction
  ros::Time last_samples_;
  tf2_ros::Buffer tf_buffer_;
  std::unique_ptr<tf2_ros::TransformListener> tf_listener_;  ///< only where tf is the source
  Diagnostics diagnostics_;
  ros::Publisher prediction_publisher_;
  ros::Publisher samples_publisher_;
  ros::Subscriber odometry_subscriber_;
  ros::Subscriber keyframe_subscriber_;
  ros::Timer tf_timer_;
  ros::WallTimer samples_timer_;
};

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  return omega_slam::runNode<omega_slam::MotionModelNode>(argc, argv, "motion_model");
}

#include "nodes/common/run_publisher.h"

#include <algorithm>

#include "nodes/common/names.h"
#include "nodes/common/slam_conversions.h"

namespace omega_slam {

RunPublisher::RunPublisher(ros::NodeHandle nh) {
  const auto send_all = [this](const auto& history) {
    return [this, &history](const ros::SingleSubscriberPublisher& subscriber) {
      const std::lock_guard<std::mutex> lock(mutex_);
      for (const auto& message : history) {
        subscriber.publish(message);
      }
    };
  };
  keyframe_publisher_ =
      nh.advertise<Keyframe>(names::kKeyframe, names::kKeyframeQueue, send_all(keyframes_));
  constraint_publisher_ = nh.advertise<ConstraintArray>(names::kConstraints, names::kKeyframeQueue,
                                                        send_all(constraints_));
  beginRun();
}

std::uint64_t RunPublisher::beginRun() {
  const std::lock_guard<std::mutex> lock(mutex_);
  // The wall's time tells the runs of two processes apart; within one, numbers only grow.
  run_ = std::max(run_ + 1, static_cast<std::uint64_t>(ros::WallTime::now().toNSec()));
  keyframes_.clear();
  constraints_.clear();
  return run_;
}

std::uint64_t RunPublisher::run() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return run_;
}

std::size_t RunPublisher::keyframes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return keyframes_.size();
}

void RunPublisher::publish(const slam::Keyframe& keyframe, const std_msgs::Header& header,
                           const std::vector<graph::Constraint>& constraints) {
  const std::lock_guard<std::mutex> lock(mutex_);
  keep(constraints, header.stamp);
  keyframes_.push_back(keyframeToRos(keyframe, header, run_));
  keyframe_publisher_.publish(keyframes_.back());
}

void RunPublisher::publish(const std::vector<graph::Constraint>& constraints, std::uint64_t run) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (run != run_) {
    return;
  }
  ros::Time newest;
  for (const graph::Constraint& constraint : constraints) {
    newest = std::max(newest, keyframes_[std::max(constraint.from, constraint.to)].header.stamp);
  }
  keep(constraints, newest);
}

void RunPublisher::keep(const std::vector<graph::Constraint>& constraints, const ros::Time& stamp) {
  if (constraints.empty()) {
    return;
  }
  ConstraintArray message;
  message.header.stamp = stamp;
  message.run = run_;
  message.constraints = constraintsToRos(constraints);
  constraints_.push_back(message);
  constraint_publisher_.publish(constraints_.back());
}

}  // namespace omega_slam

#pragma once

#include <omega_slam/ConstraintArray.h>
#include <omega_slam/Keyframe.h>
#include <ros/ros.h>

#include <cstdint>
#include <mutex>
#include <vector>

#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/slam/keyframe.h"

namespace omega_slam {

/// Publishes the keyframes and constraints of a run, and keeps them: a subscriber that comes late,
/// or comes back, is sent the whole run, so that any node can be restarted alone and at any time.
/// Whoever was there already may get a message twice; receivers know keyframes by run and id.
/// Thread-safe.
class RunPublisher {
 public:
  explicit RunPublisher(ros::NodeHandle nh);

  /// Begins a new run. @return its number
  std::uint64_t beginRun();
  [[nodiscard]] std::uint64_t run() const;
  [[nodiscard]] std::size_t keyframes() const;

  /// A keyframe, and the constraints that tie it to those before.
  /// @param header the scan's own stamp; the base frame
  void publish(const slam::Keyframe& keyframe, const std_msgs::Header& header,
               const std::vector<graph::Constraint>& constraints);
  /// Constraints found later, between keyframes of the given run; dropped where that run is over.
  void publish(const std::vector<graph::Constraint>& constraints, std::uint64_t run);

 private:
  /// The caller holds the lock.
  void keep(const std::vector<graph::Constraint>& constraints, const ros::Time& stamp);

  mutable std::mutex mutex_;
  std::uint64_t run_{0};
  std::vector<Keyframe> keyframes_;
  std::vector<ConstraintArray> constraints_;
  // Last, so that no subscriber is served before the members above exist.
  ros::Publisher keyframe_publisher_;
  ros::Publisher constraint_publisher_;
};

}  // namespace omega_slam

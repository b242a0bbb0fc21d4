#include "nodes/common/slam_conversions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "nodes/common/conversions.h"
#include "omega_slam/geometry/angle.h"

namespace omega_slam {
namespace {

bool isFiniteBeam(float x, float y) { return std::isfinite(x) && std::isfinite(y); }

std::string beamFault(const Keyframe& keyframe) {
  if (keyframe.y.size() != keyframe.x.size() || keyframe.kind.size() != keyframe.x.size()) {
    return "keyframe lists differ in length";
  }
  for (std::size_t i = 0; i < keyframe.x.size(); ++i) {
    if (keyframe.kind[i] > Keyframe::NO_RETURN) {
      return "keyframe has a beam of unknown kind";
    }
    if (keyframe.kind[i] != Keyframe::UNKNOWN && !isFiniteBeam(keyframe.x[i], keyframe.y[i])) {
      return "keyframe has a beam that is not finite";
    }
  }
  return {};
}

/// Constraints between the keyframes of a pose graph.
Reading<std::vector<graph::Constraint>> constraintsWithin(const PoseGraph& graph,
                                                          const std::vector<Constraint>& messages) {
  std::vector<graph::Constraint> read;
  for (const Constraint& message : messages) {
    const auto constraint = constraintFromRos(message);
    if (!constraint.value) {
      return {std::nullopt, "pose graph: " + constraint.fault};
    }
    if (std::max(message.from_id, message.to_id) >= graph.poses.size()) {
      return {std::nullopt, "pose graph has a constraint to a keyframe that it lacks"};
    }
    read.push_back(*constraint.value);
  }
  return {std::move(read), {}};
}

Eigen::Matrix3d informationOf(const Constraint& constraint) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
      constraint.information.data());
}

}  // namespace

Reading<slam::Keyframe> keyframeFromRos(const Keyframe& keyframe) {
  if (const std::string fault = beamFault(keyframe); !fault.empty()) {
    return {std::nullopt, fault};
  }
  const auto T_odom_base = poseFromRos(keyframe.odometry);
  const auto T_base_laser = poseFromRos(keyframe.laser);
  if (!T_odom_base || !T_base_laser || !std::isfinite(keyframe.angle_increment)) {
    return {std::nullopt, "keyframe has numbers that are not finite"};
  }
  if (keyframe.angle_increment <= 0.0) {
    return {std::nullopt, "keyframe has an angle_increment that is not positive"};
  }
  if (keyframe.stretch > keyframe.id) {
    return {std::nullopt, "keyframe has a stretch that begins after it"};
  }
  slam::Keyframe read;
  read.id = keyframe.id;
  read.stretch = keyframe.stretch;
  read.T_odom_base = *T_odom_base;
  read.sweep.stamp = keyframe.header.stamp.toSec();
  read.sweep.T_base_laser = *T_base_laser;
  read.sweep.angle_increment = keyframe.angle_increment;
  read.sweep.beams.reserve(keyframe.x.size());
  for (std::size_t i = 0; i < keyframe.x.size(); ++i) {
    const Eigen::Vector2d end(static_cast<double>(keyframe.x[i]),
                              static_cast<double>(keyframe.y[i]));
    const auto kind = static_cast<sensing::BeamKind>(keyframe.kind[i]);
    const bool says_nothing = kind == sensing::BeamKind::kUnknown;
    read.sweep.beams.push_back({says_nothing ? Eigen::Vector2d(0.0, 0.0) : end, kind});
  }
  return {std::move(read), {}};
}

Keyframe keyframeToRos(const slam::Keyframe& keyframe, const std_msgs::Header& header,
                       std::uint64_t run) {
  Keyframe message;
  message.header = header;
  message.run = run;
  message.id = keyframe.id;
  message.stretch = keyframe.stretch;
  message.odometry = pose2ToRos(keyframe.T_odom_base);
  message.laser = pose2ToRos(keyframe.sweep.T_base_laser);
  message.angle_increment = keyframe.sweep.angle_increment;
  for (const sensing::Beam& beam : keyframe.sweep.beams) {
    message.x.push_back(static_cast<float>(beam.end.x()));
    message.y.push_back(static_cast<float>(beam.end.y()));
    message.kind.push_back(static_cast<std::uint8_t>(beam.kind));
  }
  return message;
}

Reading<graph::Constraint> constraintFromRos(const Constraint& constraint) {
  if (constraint.kind > Constraint::LOOP) {
    return {std::nullopt, "constraint is of unknown kind"};
  }
  if (!(constraint.confidence >= 0.0 && constraint.confidence <= 1.0)) {
    return {std::nullopt, "constraint's confidence is not within 0 and 1"};
  }
  graph::Constraint read;
  read.from = constraint.from_id;
  read.to = constraint.to_id;
  read.T_from_to = {constraint.pose.x, constraint.pose.y, constraint.pose.theta};
  read.information = informationOf(constraint);
  read.kind = static_cast<graph::ConstraintKind>(constraint.kind);
  read.confidence = constraint.confidence;
  // Which nodes exist is for the graph to say.
  constexpr std::size_t kAnyNode = std::numeric_limits<std::size_t>::max();
  if (std::string fault = graph::faultOf(read, kAnyNode); !fault.empty()) {
    return {std::nullopt, std::move(fault)};
  }
  read.T_from_to.theta = geometry::normalizeAngle(read.T_from_to.theta);
  return {read, {}};
}

Constraint constraintToRos(const graph::Constraint& constraint) {
  Constraint message;
  message.from_id = constraint.from;
  message.to_id = constraint.to;
  message.pose = pose2ToRos(constraint.T_from_to);
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(message.information.data()) =
      constraint.information;
  message.confidence = constraint.confidence;
  message.kind = static_cast<std::uint8_t>(constraint.kind);
  return message;
}

std::vector<Constraint> constraintsToRos(const std::vector<graph::Constraint>& constraints) {
  std::vector<Constraint> messages;
  messages.reserve(constraints.size());
  for (const graph::Constraint& constraint : constraints) {
    messages.push_back(constraintToRos(constraint));
  }
  return messages;
}

Tracking trackingToRos(const slam::FrontEndResult& result, const std_msgs::Header& header,
                       std::uint64_t run) {
  Tracking message;
  message.header = header;
  message.run = run;
  message.keyframe_id = result.keyframe_before;
  message.pose = pose2ToRos(result.T_keyframe_base);
  message.is_keyframe = result.keyframe != nullptr;
  message.match_trusted = result.match_trusted;
  message.confidence = result.match ? result.match->confidence : 0.0;
  return message;
}

Reading<slam::ScanTrack> trackingFromRos(const Tracking& tracking) {
  const auto pose = poseFromRos(tracking.pose);
  if (!pose) {
    return {std::nullopt, "tracked pose is not finite"};
  }
  return {slam::ScanTrack{tracking.header.stamp.toSec(), tracking.keyframe_id, *pose,
                          tracking.is_keyframe != 0},
          {}};
}

Reading<std::vector<geometry::Pose2>> posesFromRos(const PoseGraph& graph) {
  if (graph.stamps.size() != graph.poses.size()) {
    return {std::nullopt, "pose graph has not as many stamps as poses"};
  }
  std::vector<geometry::Pose2> poses;
  poses.reserve(graph.poses.size());
  for (const omega_slam::Pose2& message : graph.poses) {
    const auto pose = poseFromRos(message);
    if (!pose) {
      return {std::nullopt, "pose graph has numbers that are not finite"};
    }
    poses.push_back(*pose);
  }
  return {std::move(poses), {}};
}

Reading<graph::PoseGraph> poseGraphFromRos(const PoseGraph& graph) {
  auto poses = posesFromRos(graph);
  if (!poses.value) {
    return {std::nullopt, std::move(poses.fault)};
  }
  graph::PoseGraph read;
  read.poses = std::move(*poses.value);
  auto constraints = constraintsWithin(graph, graph.constraints);
  if (!constraints.value) {
    return {std::nullopt, std::move(constraints.fault)};
  }
  read.constraints = std::move(*constraints.value);
  if (graph.retired.empty()) {
    return {std::move(read), {}};
  }
  read.held = {0};
  for (const graph::NodeId node : graph.retired) {
    if (node == 0 || node >= read.poses.size()) {
      return {std::nullopt, "pose graph has a retired keyframe that it lacks"};
    }
    read.held.push_back(node);
  }
  return {std::move(read), {}};
}

Reading<slam::BeliefAccount> beliefsFromRos(const PoseGraph& graph) {
  const auto is_weight = [](double weight) { return weight >= 0.0 && weight <= 1.0; };
  if (!graph.weights.empty() && graph.weights.size() != graph.constraints.size()) {
    return {std::nullopt, "pose graph has not as many weights as constraints"};
  }
  if (!std::all_of(graph.weights.begin(), graph.weights.end(), is_weight)) {
    return {std::nullopt, "pose graph has a weight that is not within 0 and 1"};
  }
  auto withdrawn = constraintsWithin(graph, graph.withdrawn);
  if (!withdrawn.value) {
    return {std::nullopt, std::move(withdrawn.fault)};
  }
  auto folded = constraintsWithin(graph, graph.folded);
  if (!folded.value) {
    return {std::nullopt, std::move(folded.fault)};
  }
  return {slam::BeliefAccount{graph.weights, std::move(*withdrawn.value), std::move(*folded.value)},
          {}};
}

PoseGraph poseGraphToRos(const graph::PoseGraph& graph, const std::vector<ros::Time>& stamps,
                         const slam::BeliefAccount& beliefs) {
  PoseGraph message;
  for (const geometry::Pose2& pose : graph.poses) {
    message.poses.push_back(pose2ToRos(pose));
  }
  message.stamps = stamps;
  message.constraints = constraintsToRos(graph.constraints);
  std::copy_if(graph.held.begin(), graph.held.end(), std::back_inserter(message.retired),
               [](graph::NodeId node) { return node != 0; });
  message.weights = beliefs.weights;
  message.withdrawn = constraintsToRos(beliefs.withdrawn);
  message.folded = constraintsToRos(beliefs.folded);
  return message;
}

}  // namespace omega_slam

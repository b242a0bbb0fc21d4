#pragma once

#include <omega_slam/Constraint.h>
#include <omega_slam/Keyframe.h>
#include <omega_slam/PoseGraph.h>
#include <omega_slam/Tracking.h>
#include <ros/time.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/slam/back_end.h"
#include "omega_slam/slam/front_end.h"
#include "omega_slam/slam/keyframe.h"
#include "omega_slam/slam/scan_trajectory.h"

/// Between the messages of this package and the library's types. Pure functions. Messages come from
/// anywhere: reading one gives its value or the reason why it can't be used.
namespace omega_slam {

/// A message read, or why not: a short stable phrase.
template <class T>
struct Reading {
  std::optional<T> value;
  std::string fault;
};

/// Faults: lists of different lengths, numbers that are not finite (where the beam says something),
/// an angle_increment that is not positive, an unknown kind of beam.
[[nodiscard]] Reading<slam::Keyframe> keyframeFromRos(const Keyframe& keyframe);

/// @param header the scan's own stamp, to the nanosecond, which a double can't hold; the base frame
/// @param run    number of the run, as in PoseGraph
[[nodiscard]] Keyframe keyframeToRos(const slam::Keyframe& keyframe, const std_msgs::Header& header,
                                     std::uint64_t run);

/// Faults: a node tied to itself, numbers that are not finite, information that is not symmetric
/// and positive semi-definite, an unknown kind, a confidence outside of [0, 1].
[[nodiscard]] Reading<graph::Constraint> constraintFromRos(const Constraint& constraint);

[[nodiscard]] Constraint constraintToRos(const graph::Constraint& constraint);
[[nodiscard]] std::vector<Constraint> constraintsToRos(
    const std::vector<graph::Constraint>& constraints);

/// What a pose graph says of how far its constraints are believed. Faults: weights that are not as
/// many as the constraints (or none) or not within 0 and 1, withdrawn loops that are not sound or
/// not between keyframes that it has.
[[nodiscard]] Reading<slam::BeliefAccount> beliefsFromRos(const PoseGraph& graph);

/// `T_map_base` of the keyframes, by id, for those whom the constraints do not concern. Faults: as
/// many stamps as poses there must be, and poses finite.
[[nodiscard]] Reading<std::vector<geometry::Pose2>> posesFromRos(const PoseGraph& graph);

/// Faults: those of posesFromRos; constraints must be sound and between nodes that exist, and
/// retired keyframes not the first one. These are held in the graph, beside node 0.
[[nodiscard]] Reading<graph::PoseGraph> poseGraphFromRos(const PoseGraph& graph);

/// Where the front end has tracked a scan. @param header the scan's own stamp; the base frame
[[nodiscard]] Tracking trackingToRos(const slam::FrontEndResult& result,
                                     const std_msgs::Header& header, std::uint64_t run);

/// Faults: a pose that is not finite.
[[nodiscard]] Reading<slam::ScanTrack> trackingFromRos(const Tracking& tracking);

/// Run and header are left to the caller. @param stamps of the keyframes, as many as there are
/// poses
[[nodiscard]] PoseGraph poseGraphToRos(const graph::PoseGraph& graph,
                                       const std::vector<ros::Time>& stamps,
                                       const slam::BeliefAccount& beliefs = {});

}  // namespace omega_slam

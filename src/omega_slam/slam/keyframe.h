#pragma once

#include <memory>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/matching/scan_matcher.h"
#include "omega_slam/sensing/sweep.h"

namespace omega_slam::slam {

/// A pose of the robot kept in the graph, with the sweep taken there and its odometry.
struct Keyframe {
  graph::NodeId id{0};
  geometry::Pose2 T_odom_base;  ///< odometry at `sweep.stamp`
  sensing::Sweep sweep;
  /// The first keyframe of its stretch: from there on, each has seen something of what the one
  /// before saw. From one stretch to the next there is nothing but odometry, or a place found
  /// again.
  graph::NodeId stretch{0};
};

/// Where the newest keyframes of its stretch begin: a keyframe and no more than count - 1 before
/// it.
[[nodiscard]] graph::NodeId beginOfNewest(graph::NodeId count, const Keyframe& newest);

/// What a sweep saw, in the frame of the robot's base.
[[nodiscard]] matching::View viewOf(const sensing::Sweep& sweep);

/// A scan match between two keyframes as a constraint of the graph.
[[nodiscard]] graph::Constraint matchConstraint(graph::NodeId from, graph::NodeId to,
                                                const matching::MatchResult& match,
                                                graph::ConstraintKind kind);

/// Keyframes never change once made, so they are shared freely between threads.
using KeyframePtr = std::shared_ptr<const Keyframe>;

/// The sweep of a keyframe, which lives as long as anybody holds it.
[[nodiscard]] inline std::shared_ptr<const sensing::Sweep> sweepOf(const KeyframePtr& keyframe) {
  return {keyframe, &keyframe->sweep};
}

}  // namespace omega_slam::slam

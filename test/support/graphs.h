#pragma once

#include <random>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::test {

/// What says exactly this of two nodes, with `weight` times the unit matrix as information.
[[nodiscard]] graph::Constraint tie(graph::NodeId from, graph::NodeId to,
                                    const geometry::Pose2& T_from_to = {}, double weight = 1.0,
                                    graph::ConstraintKind kind = graph::ConstraintKind::kOdometry);

/// Positive definite, with correlations.
[[nodiscard]] Eigen::Matrix3d randomInformation(std::mt19937_64& random);

/// What would be measured between two true poses, off by up to `noise` [m], [rad].
[[nodiscard]] graph::Constraint measure(const std::vector<geometry::Pose2>& truth,
                                        graph::NodeId from, graph::NodeId to, double noise,
                                        std::mt19937_64& random);

/// A graph of which the truth is known.
struct GraphProblem {
  std::vector<geometry::Pose2> truth;
  graph::PoseGraph graph;
};

struct WalkConfig {
  graph::NodeId nodes{40};
  int loops{15};
  double noise{0.05};       ///< [m], [rad] of measurements
  double disturbance{0.0};  ///< [m], [rad] of the first guess
};

/// A random walk of steps of half a metre, with loops between random nodes; the first guess is the
/// truth, disturbed.
[[nodiscard]] GraphProblem randomWalk(const WalkConfig& config, std::mt19937_64& random);

}  // namespace omega_slam::test

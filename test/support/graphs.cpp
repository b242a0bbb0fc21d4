#include "support/graphs.h"

#include "support/poses.h"

namespace omega_slam::test {

using geometry::Pose2;
using graph::Constraint;
using graph::ConstraintKind;
using graph::NodeId;

Constraint tie(NodeId from, NodeId to, const Pose2& T_from_to, double weight, ConstraintKind kind) {
  Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.T_from_to = T_from_to;
  constraint.information = weight * Eigen::Matrix3d::Identity();
  constraint.kind = kind;
  return constraint;
}

Eigen::Matrix3d randomInformation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::Matrix3d a;
  for (int i = 0; i < 9; ++i) {
    a(i / 3, i % 3) = normal(random);
  }
  return 20.0 * (a * a.transpose() + Eigen::Matrix3d::Identity());
}

Constraint measure(const std::vector<Pose2>& truth, NodeId from, NodeId to, double noise,
                   std::mt19937_64& random) {
  Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.T_from_to = relativePose(truth[from], truth[to]) *
                         (noise > 0.0 ? randomPose(noise, noise, random) : Pose2{});
  constraint.information = randomInformation(random);
  return constraint;
}

GraphProblem randomWalk(const WalkConfig& config, std::mt19937_64& random) {
  GraphProblem problem;
  problem.truth.push_back({});
  for (NodeId i = 1; i < config.nodes; ++i) {
    problem.truth.push_back(problem.truth.back() * Pose2{0.5, 0.0, 0.0} *
                            randomPose(0.1, 0.4, random));
  }
  auto& constraints = problem.graph.constraints;
  for (NodeId i = 0; i + 1 < config.nodes; ++i) {
    constraints.push_back(measure(problem.truth, i, i + 1, config.noise, random));
  }
  for (int i = 0; i < config.loops; ++i) {
    const auto from = static_cast<NodeId>(random() % config.nodes);
    const auto to = static_cast<NodeId>(random() % config.nodes);
    if (from != to) {
      constraints.push_back(measure(problem.truth, from, to, config.noise, random));
      constraints.back().kind = ConstraintKind::kLoop;
    }
  }
  problem.graph.poses = problem.truth;
  for (std::size_t i = 1; i < problem.truth.size(); ++i) {
    problem.graph.poses[i] =
        problem.graph.poses[i] * randomPose(config.disturbance, config.disturbance, random);
  }
  return problem;
}

}  // namespace omega_slam::test

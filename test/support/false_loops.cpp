#include "support/false_loops.h"

#include "omega_slam/geometry/angle.h"
#include "support/poses.h"

namespace omega_slam::test {

using geometry::Pose2;
using graph::Constraint;
using graph::ConstraintKind;
using graph::NodeId;

namespace {

Constraint measureNormally(const GraphProblem& problem, NodeId from, NodeId to,
                           const RoundsConfig& config, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Eigen::Vector3d deviations(config.deviation, config.deviation, 0.5 * config.deviation);
  Eigen::Vector3d error;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    error[axis] = deviations[axis] * normal(random);
  }
  Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.T_from_to =
      relativePose(problem.truth[from], problem.truth[to]) * Pose2::fromVector(error);
  constraint.information =
      config.confidence * deviations.cwiseAbs2().cwiseInverse().asDiagonal().toDenseMatrix();
  return constraint;
}

}  // namespace

GraphProblem drivenRounds(const RoundsConfig& config, std::mt19937_64& random) {
  GraphProblem problem;
  const NodeId round = 4 * config.side;
  const NodeId nodes = round * static_cast<NodeId>(config.rounds);
  problem.truth.push_back({});
  for (NodeId i = 1; i < nodes; ++i) {
    const double turn = i % config.side == 0 ? 0.5 * geometry::kPi : 0.0;
    problem.truth.push_back(problem.truth.back() * Pose2{0.5, 0.0, turn});
  }
  auto& constraints = problem.graph.constraints;
  for (NodeId i = 0; i + 1 < nodes; ++i) {
    constraints.push_back(measureNormally(problem, i, i + 1, config, random));
  }
  for (NodeId i = round; i < nodes; ++i) {
    constraints.push_back(measureNormally(problem, i - round, i, config, random));
    constraints.back().kind = ConstraintKind::kLoop;
  }
  problem.graph.poses = problem.truth;
  return problem;
}

std::size_t addFalseLoops(GraphProblem& problem, int groups, int of_each, std::mt19937_64& random) {
  const Constraint pattern = problem.graph.constraints.back();
  const auto size = static_cast<NodeId>(of_each);
  const auto nodes = static_cast<NodeId>(problem.truth.size()) - size;
  for (int group = 0; group < groups; ++group) {
    const auto first = static_cast<NodeId>(random() % nodes);
    const auto second = static_cast<NodeId>((first + 5 + random() % (nodes - 10)) % nodes);
    const Pose2 claim = randomPose(5.0, geometry::kPi, random);
    for (NodeId i = 0; i < size; ++i) {
      Constraint loop = pattern;
      loop.from = first + i;
      loop.to = second + i;
      loop.T_from_to = relativePose(problem.truth[loop.from], problem.truth[first]) * claim *
                       relativePose(problem.truth[second], problem.truth[loop.to]);
      loop.kind = ConstraintKind::kLoop;
      problem.graph.constraints.push_back(loop);
    }
  }
  return static_cast<std::size_t>(groups) * size;
}

}  // namespace omega_slam::test

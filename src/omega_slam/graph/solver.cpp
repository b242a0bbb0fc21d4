#include "omega_slam/graph/solver.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/validation.h"
#include "omega_slam/graph/graduated_truncation.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/topology.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

constexpr int kMaxStages = 100;
constexpr int kStageIterations = 2;  // the next stage goes on from wherever a stage has come to

std::vector<double> squaredErrors(const PoseGraph& graph, const std::vector<std::size_t>& indices) {
  std::vector<double> squared;
  squared.reserve(indices.size());
  for (const std::size_t k : indices) {
    squared.push_back(chiSquare(graph, graph.constraints[k]));
  }
  return squared;
}

std::vector<double> weightsOf(const PoseGraph& graph, const Weighing& weighing) {
  std::vector<double> weights;
  weights.reserve(graph.constraints.size());
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    weights.push_back(
        weighing.isPlain(k) ? 1.0 : weighing.at(k, chiSquare(graph, graph.constraints[k])).weight);
  }
  return weights;
}

SolveStatus statusOf(DescentEnd end) {
  switch (end) {
    case DescentEnd::kConverged:
      return SolveStatus::kConverged;
    case DescentEnd::kIterationLimit:
      return SolveStatus::kIterationLimit;
    case DescentEnd::kSingular:
      break;
  }
  return SolveStatus::kFailed;
}

}  // namespace

std::vector<std::string> SolverConfig::validate() const {
  geometry::Violations violations;
  violations.requireAtLeast("max_iterations", limits.max_iterations, 1);
  violations.requireWithin("relative_gain", limits.relative_gain, 0.0, 1.0);
  violations.include("kernels", kernels.validate());
  return violations.sentences();
}

GraphSolver::GraphSolver(const SolverConfig& config) : config_(config) {
  geometry::throwIfAny(config_.validate());
}

DescentAccount GraphSolver::descend(const DescentTask& task, const DescentLimits& limits) const {
  return config_.method == SolverMethod::kLevenbergMarquardt ? descendDamped(task, limits)
                                                             : descendGaussNewton(task, limits);
}

DescentAccount GraphSolver::graduate(PoseGraph& graph, Weighing& weighing) {
  const DescentTask task{graph, system_, weighing};
  DescentAccount account = descend(task, config_.limits);
  GraduatedTruncation stages(config_.kernels.loop.width,
                             squaredErrors(graph, weighing.graduated()));
  const auto goOn = [&](const DescentLimits& limits) {
    const DescentAccount next = descend(task, limits);
    account.end = next.end;
    account.chi_squares.insert(account.chi_squares.end(), next.chi_squares.begin(),
                               next.chi_squares.end());
  };
  bool is_decided = !stages.isNeeded();
  for (int stage = 0; !is_decided && stage < kMaxStages; ++stage, stages.advance()) {
    const auto weights = stages.weights(squaredErrors(graph, weighing.graduated()));
    weighing.setStage(weights);
    is_decided = areDecided(weights);
    goOn({kStageIterations, config_.limits.relative_gain});
    if (account.end == DescentEnd::kSingular) {
      return account;
    }
  }
  goOn(config_.limits);
  return account;
}

DescentAccount GraphSolver::solvePaper(PoseGraph& graph) {
  InformationForm& form = system_.form();
  form.clear();
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    const Constraint& constraint = graph.constraints[k];
    form.add(k,
             paperConstraint(constraint, graph.poses[constraint.from], graph.poses[constraint.to]),
             Eigen::Matrix3d::Identity());
  }
  const auto step = system_.solve();
  if (!step) {
    return {DescentEnd::kSingular, {}};
  }
  moveBy(graph.poses, *step);
  return {DescentEnd::kConverged, {chiSquare(graph)}};
}

SolveReport GraphSolver::solve(PoseGraph& graph) {
  SolveReport report;
  report.initial_chi_square = report.chi_square = chiSquare(graph);
  if (graph.constraints.empty()) {
    return report;
  }
  if (!std::isfinite(report.initial_chi_square)) {
    report.status = SolveStatus::kFailed;
    report.message = "a pose or a constraint is not finite";
    return report;
  }
  const SpanningForest forest = spanningForest(graph);
  if (forest.roots.size() > std::max<std::size_t>(graph.held.size(), 1)) {
    report.message =
        fmt::format("the graph is not connected: {} nodes are held, one in each part at least",
                    forest.roots.size());
  }
  system_.prepare(graph, forest.roots);
  const std::vector<Pose2> before = graph.poses;
  Weighing weighing(config_.kernels, graph);
  DescentAccount account;
  if (config_.method == SolverMethod::kLinear) {
    account = solvePaper(graph);
  } else if (weighing.graduated().empty()) {
    account = descend({graph, system_, weighing}, config_.limits);
  } else {
    account = graduate(graph, weighing);
  }
  report.status = statusOf(account.end);
  if (report.status == SolveStatus::kFailed) {
    graph.poses = before;
    report.message = "the information matrix is singular: some pose is not determined by the rest";
  }
  report.iterations = static_cast<int>(account.chi_squares.size());
  report.factorizations = system_.factorizations();
  if (report.status != SolveStatus::kFailed && !account.chi_squares.empty()) {
    report.chi_square = account.chi_squares.back();
  }
  report.chi_squares = std::move(account.chi_squares);
  report.weights = weightsOf(graph, weighing);
  return report;
}

SolveReport solve(PoseGraph& graph, const SolverConfig& config) {
  return GraphSolver(config).solve(graph);
}

Pose2 relaxNode(const PoseGraph& graph, NodeId node, const std::vector<Constraint>& constraints) {
  constexpr int kIterations = 5;
  Pose2 T_map_node = graph.poses[node];
  for (int i = 0; i < kIterations; ++i) {
    Eigen::Matrix3d omega = Eigen::Matrix3d::Zero();
    Eigen::Vector3d xi = Eigen::Vector3d::Zero();
    for (const Constraint& constraint : constraints) {
      const bool is_to = constraint.to == node;
      const LinearizedConstraint at =
          linearize(constraint, is_to ? graph.poses[constraint.from] : T_map_node,
                    is_to ? T_map_node : graph.poses[constraint.to]);
      const Eigen::Matrix3d& jacobian = is_to ? at.J_to : at.J_from;
      omega += jacobian.transpose() * constraint.information * jacobian;
      xi -= jacobian.transpose() * constraint.information * at.error;
    }
    const Eigen::Vector3d step = omega.ldlt().solve(xi);
    if (!step.allFinite()) {
      break;
    }
    T_map_node = Pose2::fromVector(T_map_node.vector() + step);
  }
  return T_map_node;
}

}  // namespace omega_slam::graph

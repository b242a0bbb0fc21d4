#include "omega_slam/graph/solver.h"

// CHOLMOD's header before Eigen's wrapper, which expects it.
#include <cholmod.h>

#include <Eigen/Cholesky>
#include <Eigen/CholmodSupport>
#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

using Cholesky = Eigen::CholmodDecomposition<Eigen::SparseMatrix<double>, Eigen::Lower>;

constexpr int kHalvings = 8;  // of a step that leads uphill

/// Huber's cost of a squared error, and the weight by which its quadratic is scaled (Huber 1964).
struct RobustCost {
  double cost;
  double weight;
};

RobustCost robustCost(const Constraint& constraint, double squared, double kernel) {
  const bool quadratic =
      constraint.kind != ConstraintKind::kLoop || kernel <= 0.0 || squared <= kernel * kernel;
  if (quadratic) {
    return {squared, 1.0};
  }
  const double error = std::sqrt(squared);
  return {2.0 * kernel * error - kernel * kernel, kernel / error};
}

LinearizedConstraint linearizeAt(const PoseGraph& graph, const Constraint& constraint) {
  return linearize(constraint, graph.poses[constraint.from], graph.poses[constraint.to]);
}

double squaredError(const Constraint& constraint, const LinearizedConstraint& at) {
  return at.error.dot(constraint.information * at.error);
}

double totalCost(const PoseGraph& graph, double kernel) {
  double cost = 0.0;
  for (const Constraint& constraint : graph.constraints) {
    cost += robustCost(constraint, chiSquare(graph, constraint), kernel).cost;
  }
  return cost;
}

/// Omega and xi for the step from the graph's poses: e(pose + step) = e + J step, so z = -e.
InformationForm buildStep(const PoseGraph& graph, double kernel) {
  InformationForm form(graph.poses.size());
  for (const Constraint& constraint : graph.constraints) {
    const LinearizedConstraint at = linearizeAt(graph, constraint);
    const double weight = robustCost(constraint, squaredError(constraint, at), kernel).weight;
    form.add(constraint.from, constraint.to, at.J_from, at.J_to, weight * constraint.information,
             -at.error);
  }
  form.anchor(0, Eigen::Vector3d::Zero(), 1.0);
  return form;
}

/// Node 0 is the anchor: its step is zero but for rounding, and rounding shall not move it.
void moveBy(std::vector<Pose2>& poses, const Eigen::VectorXd& step, double share) {
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Eigen::Vector3d change = share * step.segment<3>(3 * static_cast<Eigen::Index>(i));
    poses[i] = Pose2::fromVector(poses[i].vector() + change);
  }
}

/// Takes the step, or half of it, or a quarter ... until the cost falls.
/// @return the new cost, or none if no share of the step helps; then the poses are as before
std::optional<double> takeStep(PoseGraph& graph, const Eigen::VectorXd& step, double cost,
                               double kernel) {
  const std::vector<Pose2> before = graph.poses;
  double share = 1.0;
  for (int i = 0; i <= kHalvings; ++i, share *= 0.5) {
    graph.poses = before;
    moveBy(graph.poses, step, share);
    const double moved = totalCost(graph, kernel);
    if (std::isfinite(moved) && moved <= cost) {
      return moved;
    }
  }
  graph.poses = before;
  return std::nullopt;
}

}  // namespace

std::vector<std::string> SolverConfig::validate() const {
  geometry::Violations violations;
  violations.requireAtLeast("max_iterations", max_iterations, 1);
  violations.requireWithin("relative_gain", relative_gain, 0.0, 1.0);
  violations.requireAtLeast("loop_kernel", loop_kernel, 0.0);
  return violations.sentences();
}

std::optional<Eigen::VectorXd> solveLinear(const InformationForm& form) {
  Cholesky cholesky;
  cholesky.cholmod().print = 0;  // a matrix that can't be factorised is an answer, not an event
  cholesky.compute(form.omega());
  if (cholesky.info() != Eigen::Success) {
    return std::nullopt;
  }
  Eigen::VectorXd mu = cholesky.solve(form.xi());
  if (!mu.allFinite()) {
    return std::nullopt;
  }
  return mu;
}

SolveReport solve(PoseGraph& graph, const SolverConfig& config) {
  SolveReport report;
  report.initial_chi_square = chiSquare(graph);
  report.chi_square = report.initial_chi_square;
  if (graph.constraints.empty()) {
    return report;
  }
  double cost = totalCost(graph, config.loop_kernel);
  report.status = SolveStatus::kIterationLimit;
  while (report.iterations < config.max_iterations) {
    const auto step = solveLinear(buildStep(graph, config.loop_kernel));
    if (!step) {
      report.status = SolveStatus::kFailed;
      report.message = "the information matrix is singular: part of the graph is not connected";
      break;
    }
    ++report.iterations;
    const auto moved = takeStep(graph, *step, cost, config.loop_kernel);
    const double gain = moved ? cost - *moved : 0.0;
    cost = moved.value_or(cost);
    if (gain <= config.relative_gain * cost) {
      report.status = SolveStatus::kConverged;
      break;
    }
  }
  report.chi_square = chiSquare(graph);
  return report;
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

double chiSquare(const PoseGraph& graph, const Constraint& constraint) {
  return squaredError(constraint, linearizeAt(graph, constraint));
}

double chiSquare(const PoseGraph& graph) {
  double sum = 0.0;
  for (const Constraint& constraint : graph.constraints) {
    sum += chiSquare(graph, constraint);
  }
  return sum;
}

}  // namespace omega_slam::graph

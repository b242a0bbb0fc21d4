#include "omega_slam/graph/descent.h"

#include <cmath>

#include "omega_slam/graph/linearization.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

constexpr int kHalvings = 8;         // of a step that leads uphill
constexpr double kRounding = 1e-12;  // of a cost that should be zero
constexpr double kKept = 0.9;        // share of a promise
constexpr double kFirstDamping = 1e-4;
constexpr double kMaxDamping = 1e8;

GraphCost fill(const DescentTask& task) {
  return fillForm(task.graph, task.weighing, task.system.form());
}

bool isBetter(const GraphCost& moved, const GraphCost& before) {
  return std::isfinite(moved.robust) && moved.robust <= before.robust;
}

/// Takes the step, or half of it, or a quarter ... until the cost falls. Fills the system anew.
/// @return the new costs, or none if no share of the step helps; then the poses are as before
std::optional<GraphCost> takeStep(const DescentTask& task, const Eigen::VectorXd& step,
                                  const GraphCost& costs) {
  const std::vector<Pose2> before = task.graph.poses;
  double share = 1.0;
  for (int i = 0; i <= kHalvings; ++i, share *= 0.5) {
    moveBy(task.graph.poses, step, share);
    const GraphCost moved = fill(task);
    if (isBetter(moved, costs)) {
      return moved;
    }
    task.graph.poses = before;
  }
  return std::nullopt;
}

}  // namespace

GraphCost fillForm(const PoseGraph& graph, const Weighing& weighing, InformationForm& form) {
  GraphCost cost;
  form.clear();
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    const Constraint& constraint = graph.constraints[k];
    const LinearizedConstraint at = linearize(constraint, graph);
    const double squared = at.error.dot(constraint.information * at.error);
    const RobustCost robust = weighing.at(k, squared);
    cost.robust += robust.cost;
    cost.chi_square += squared;
    if (robust.weight > 0.0) {
      form.add(k, at, robust.weight * constraint.information);
    }
  }
  for (const NodeId point : graph.points) {
    form.addDiagonal(point, 2, 1.0);  // the heading that it does not have stays where it is
  }
  return cost;
}

void moveBy(std::vector<Pose2>& poses, const Eigen::VectorXd& step, double share) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d change = share * step.segment<3>(3 * static_cast<Eigen::Index>(i));
    if (!change.isZero(0.0)) {
      poses[i] = Pose2::fromVector(poses[i].vector() + change);
    }
  }
}

DescentAccount descendGaussNewton(const DescentTask& task, const DescentLimits& limits) {
  DescentAccount account;
  GraphCost costs = fill(task);
  const auto promiseOf = [&](const Eigen::VectorXd& step) {
    return step.dot(task.system.form().xi());
  };
  const auto isTooLittle = [&](double gain) {
    return gain <= limits.relative_gain * costs.robust + kRounding;
  };
  for (int iteration = 0; iteration < limits.max_iterations; ++iteration) {
    const auto step = task.system.solve();
    if (!step) {
      account.end = DescentEnd::kSingular;
      return account;
    }
    const double promise = promiseOf(*step);
    if (isTooLittle(promise)) {
      return account;
    }
    const GraphCost moved = takeStep(task, *step, costs).value_or(costs);
    const double gain = costs.robust - moved.robust;
    costs = moved;
    account.chi_squares.push_back(costs.chi_square);
    // Where a step has kept its promise, Omega has hardly moved: the last factor, which is at hand,
    // says well enough what is left to gain.
    const bool is_kept = gain > kKept * promise;
    if (isTooLittle(gain) ||
        (is_kept && isTooLittle(promiseOf(task.system.solveFor(task.system.form().xi()))))) {
      return account;
    }
  }
  account.end = DescentEnd::kIterationLimit;
  return account;
}

DescentAccount descendDamped(const DescentTask& task, const DescentLimits& limits) {
  DescentAccount account;
  GraphCost costs = fill(task);
  double damping = kFirstDamping;
  double growth = 2.0;
  for (int iteration = 0; iteration < limits.max_iterations; ++iteration) {
    task.system.form().damp(damping);
    const auto step = task.system.solve();
    const std::vector<Pose2> before = task.graph.poses;
    if (step) {
      moveBy(task.graph.poses, *step);
    }
    const GraphCost moved = fill(task);
    if (step && isBetter(moved, costs)) {
      const double gain = costs.robust - moved.robust;
      costs = moved;
      account.chi_squares.push_back(costs.chi_square);
      damping /= 3.0;
      growth = 2.0;
      if (gain <= limits.relative_gain * costs.robust) {
        account.end = DescentEnd::kConverged;
        return account;
      }
      continue;
    }
    task.graph.poses = before;
    fill(task);
    account.chi_squares.push_back(costs.chi_square);
    damping *= growth;
    growth *= 2.0;
    if (damping > kMaxDamping) {
      account.end = step ? DescentEnd::kConverged : DescentEnd::kSingular;
      return account;
    }
  }
  account.end = DescentEnd::kIterationLimit;
  return account;
}

}  // namespace omega_slam::graph

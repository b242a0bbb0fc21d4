#include "omega_slam/graph/incremental_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"
#include "omega_slam/graph/descent.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/neighbourhood.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

/// What stands on the diagonal for nodes that are yet to come; far below what any constraint says.
constexpr double kNothingKnown = 1e-9;
/// So many of the newest nodes are ordered last, since the next constraints are theirs.
constexpr std::size_t kOpenNodes = 2;
/// Steps of the whole for one loop at most: the next loops go on with it.
constexpr int kBatchesAtOnce = 2;
/// [constraints] from a new one up to which poses follow it first.
constexpr int kReach = 15;
/// A part of the graph is worth a solve of its own if the whole is so many times as large,
constexpr std::size_t kWorthwhile = 2;
/// and has so many nodes: below, the whole is solved soon enough, and is truer.
constexpr std::size_t kLarge = 2000;
/// [m] As long as the outer half of that part moves by less, the rest stays where it is.
constexpr double kStill = 1e-3;

}  // namespace

std::vector<std::string> IncrementalConfig::validate() const {
  geometry::Violations violations;
  violations.include("solver", solver.validate());
  violations.requireAtLeast("batch_nodes", batch_nodes, 1);
  violations.requireAbove("max_turn", max_turn, 0.0);
  violations.requireAbove("max_move", max_move, 0.0);
  return violations.sentences();
}

IncrementalSolver::IncrementalSolver(const IncrementalConfig& config)
    : config_(config), solver_(config.solver) {
  geometry::throwIfAny(config_.validate());
}

void IncrementalSolver::addNode(const Pose2& T_map_node,
                                const std::vector<Constraint>& constraints) {
  const auto node = static_cast<NodeId>(graph_.poses.size());
  graph_.poses.push_back(T_map_node);
  graph_.poses.back() = relaxNode(graph_, node, constraints);
  graph_.constraints.insert(graph_.constraints.end(), constraints.begin(), constraints.end());
  // A leaf lies at its optimum already: a factor is made when a loop asks for one.
  if (!cholesky_ || part_.size() == capacity_) {
    cholesky_.reset();
    return;
  }
  part_.append(node);
  linearized_at_.push_back(graph_.poses.back());
  if (!isFor(constraints)) {
    cholesky_.reset();
    return;
  }
  for (const Constraint& constraint : constraints) {
    include(constraint);
  }
}

void IncrementalSolver::addConstraints(const std::vector<Constraint>& constraints) {
  graph_.constraints.insert(graph_.constraints.end(), constraints.begin(), constraints.end());
  if (!cholesky_ && relaxAround(constraints)) {
    return;
  }
  if (!cholesky_ || !isFor(constraints)) {
    batch();
    return;
  }
  for (const Constraint& constraint : constraints) {
    include(constraint);
  }
  follow();
  for (int i = 0; i < kBatchesAtOnce && isStale(); ++i) {
    batch();
  }
}

bool IncrementalSolver::isFor(const std::vector<Constraint>& constraints) const {
  return std::all_of(constraints.begin(), constraints.end(), [this](const Constraint& constraint) {
    return part_.has(constraint.from) && part_.has(constraint.to);
  });
}

void IncrementalSolver::include(const Constraint& constraint) {
  const Constraint renumbered = part_.renumbered(constraint);
  const LinearizedConstraint at =
      linearize(renumbered, linearized_at_[renumbered.from], linearized_at_[renumbered.to]);
  const double squared = chiSquare(graph_, constraint);
  const double weight = config_.solver.kernels.of(constraint.kind).at(squared).weight;
  cholesky_->add(renumbered, at, weight);
}

void IncrementalSolver::follow() {
  const Eigen::VectorXd mu = cholesky_->solve();
  if (mu.allFinite()) {
    std::vector<Pose2> poses = linearized_at_;
    moveBy(poses, mu.head(3 * static_cast<Eigen::Index>(poses.size())));
    part_.place(poses, graph_);
  }
}

bool IncrementalSolver::isStale() const {
  for (std::size_t i = 0; i < part_.size(); ++i) {
    const Pose2& pose = graph_.poses[part_.nodes()[i]];
    const Pose2& before = linearized_at_[i];
    if (std::abs(geometry::angleDifference(pose.theta, before.theta)) > config_.max_turn ||
        geometry::distance(pose, before) > config_.max_move) {
      return true;
    }
  }
  return false;
}

void IncrementalSolver::batch() {
  ++batches_;
  solved_ = graph_.poses.size();
  part_ = EstimatedPart(graph_);
  PoseGraph roomy = part_.of(graph_);
  linearized_at_ = roomy.poses;
  const std::size_t nodes = part_.size();
  capacity_ = nodes + static_cast<std::size_t>(config_.batch_nodes);
  roomy.poses.resize(capacity_);
  const std::vector<NodeId> first{0};
  InformationForm form(capacity_, roomy.constraints, roomy.held.empty() ? first : roomy.held);
  fillForm(roomy, Weighing(config_.solver.kernels, roomy), form);
  for (std::size_t node = nodes; node < capacity_; ++node) {
    for (int axis = 0; axis < 3; ++axis) {
      form.addDiagonal(static_cast<NodeId>(node), axis, kNothingKnown);
    }
  }
  cholesky_ = std::make_unique<UpdatableCholesky>(
      form, static_cast<NodeId>(nodes - std::min(nodes, kOpenNodes)));
  if (cholesky_->isValid()) {
    follow();
  }
}

void IncrementalSolver::place(NodeId node, const Pose2& T_map_node) {
  graph_.poses[node] = T_map_node;
}

bool IncrementalSolver::settleAround(const std::vector<Constraint>& constraints) {
  graph_.constraints.insert(graph_.constraints.end(), constraints.begin(), constraints.end());
  cholesky_.reset();  // weights change, and poses by more than its linearisation may be good for
  return relaxAround(constraints);
}

bool IncrementalSolver::relaxAround(const std::vector<Constraint>& constraints) {
  if (graph_.poses.size() < kLarge ||
      graph_.poses.size() >= solved_ + static_cast<std::size_t>(config_.batch_nodes)) {
    return false;  // what parts are let off by must not add up
  }
  const Neighbourhood near(graph_, constraints, kReach);
  if (kWorthwhile * near.size() > graph_.poses.size()) {
    return false;
  }
  PoseGraph part = near.of(graph_);
  if (solve(part, config_.solver).status != SolveStatus::kConverged ||
      near.outerMotion(part, graph_) > kStill) {
    return false;
  }
  near.place(part, graph_);
  return true;
}

SolveReport IncrementalSolver::withdraw(std::size_t k) {
  graph_.constraints.erase(graph_.constraints.begin() + static_cast<std::ptrdiff_t>(k));
  return finish();
}

SolveReport IncrementalSolver::resume(PoseGraph graph) {
  graph_ = std::move(graph);
  return finish();
}

void IncrementalSolver::goOnWith(PoseGraph graph) {
  graph_ = std::move(graph);
  cholesky_.reset();
}

SolveReport IncrementalSolver::finish() {
  cholesky_.reset();
  solved_ = graph_.poses.size();
  const EstimatedPart part(graph_);
  PoseGraph estimated = part.of(graph_);
  SolveReport report = solver_.solve(estimated);
  part.place(estimated.poses, graph_);
  return report;
}

}  // namespace omega_slam::graph

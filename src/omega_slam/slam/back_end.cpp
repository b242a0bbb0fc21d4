#include "omega_slam/slam/back_end.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "omega_slam/geometry/validation.h"
#include "omega_slam/graph/linearization.h"

namespace omega_slam::slam {

using geometry::Pose2;
using graph::Constraint;
using graph::NodeId;

namespace {

/// By which factor the squared error of a loop that was let be must grow to call for a new doubt.
constexpr double kWorse = 2.0;

/// [keyframes] between two looks for some that may retire: each is worth a solve of the whole.
constexpr std::size_t kRetireEvery = 50;

/// A graph of so many keyframes takes long to doubt: step by step, one for each new keyframe, and
/// not before one in so many of them has come since the last.
constexpr std::size_t kLarge = 2000;
constexpr std::size_t kDoubtShare = 50;

bool areLoops(const std::vector<Constraint>& constraints) {
  return std::all_of(constraints.begin(), constraints.end(),
                     [](const Constraint& c) { return c.kind == graph::ConstraintKind::kLoop; });
}

/// First guess of a node's pose: by the constraint that says most of it.
Pose2 placeByBest(const graph::PoseGraph& graph, NodeId node,
                  const std::vector<Constraint>& constraints) {
  const auto best = std::max_element(constraints.begin(), constraints.end(),
                                     [](const Constraint& a, const Constraint& b) {
                                       return a.information.trace() < b.information.trace();
                                     });
  return best->to == node ? graph.poses[best->from] * best->T_from_to
                          : graph.poses[best->to] * best->T_from_to.inverse();
}

}  // namespace

std::vector<std::string> BackEndConfig::validate() const {
  geometry::Violations violations;
  violations.include("graph", graph.validate());
  violations.requireAtLeast("solve_error", solve_error, 0.0);
  violations.include("doubt", doubt.validate());
  violations.include("thinning", thinning.validate());
  return violations.sentences();
}

BackEnd::BackEnd(const BackEndConfig& config) : config_(config), solver_(config.graph) {
  geometry::throwIfAny(config_.validate());
  config_.thinning.kernels = config_.graph.solver.kernels;
}

std::string BackEnd::addKeyframe(NodeId id, const Pose2& T_odom_base,
                                 const std::vector<Constraint>& constraints) {
  if (id != graph().poses.size()) {
    return "keyframe out of turn";
  }
  if (!T_odom_base.isFinite()) {
    return "keyframe's odometry is not finite";
  }
  std::vector<Constraint> valid;
  std::copy_if(constraints.begin(), constraints.end(), std::back_inserter(valid),
               [&](const Constraint& c) {
                 return graph::faultOf(c, id + 1).empty() && (c.from == id) != (c.to == id);
               });
  if (id > 0 && valid.empty()) {
    return "keyframe without a valid constraint";
  }
  std::transform(valid.begin(), valid.end(), valid.begin(),
                 [this](const Constraint& c) { return retired_.carried(c); });
  solver_.addNode(id > 0 ? placeByBest(graph(), id, valid) : Pose2{}, valid);
  T_odom_newest_ = T_odom_base;
  goOnDoubting();
  if (!doubt_ && graph().poses.size() >= looked_at_ + kRetireEvery) {
    retireSome();
  }
  return {};
}

std::string BackEnd::addConstraints(const std::vector<Constraint>& constraints) {
  std::string refusal;
  std::vector<Constraint> valid;
  double error = 0.0;  // largest [standard deviations]
  for (const Constraint& constraint : constraints) {
    const std::string fault = graph::faultOf(constraint, graph().poses.size());
    if (!fault.empty()) {
      refusal = refusal.empty() ? fault : refusal;
      continue;
    }
    const Constraint carried = retired_.carried(constraint);
    if (carried.from != carried.to) {
      valid.push_back(carried);
      error = std::max(error, std::sqrt(graph::chiSquare(graph(), carried)));
    }
  }
  if (error > config_.solve_error && isLarge() && areLoops(valid)) {
    addUndoubted(valid);
  } else if (error > config_.solve_error) {
    if (!solver_.settleAround(valid) || isAnyLoopFarOff()) {
      solve();
    } else {
      moveRetired();
    }
  } else if (!valid.empty()) {
    solver_.addConstraints(valid);
    moveRetired();
  }
  return refusal;
}

bool BackEnd::isLarge() const { return graph().poses.size() >= kLarge; }

/// One step of a doubt for a keyframe: to begin, a round, to conclude.
void BackEnd::goOnDoubting() {
  const std::size_t count = graph().poses.size();
  if (!doubt_) {
    const bool is_due = doubts_ == 0 || count >= doubted_at_ + count / kDoubtShare;
    if (is_doubt_called_ && isLarge() && is_due) {
      beginDoubt();
    }
  } else if (!doubt_->advance()) {
    concludeDoubt();
    moveRetired();
  }
}

/// Loops that contradict the others are kept for the next doubt: it says who is right.
void BackEnd::addUndoubted(const std::vector<Constraint>& loops) {
  graph::PoseGraph before = graph();
  if (!solver_.settleAround(loops)) {
    report_ = solver_.finish();
  }
  if (isAnyLoopFarOff()) {
    withdrawn_.insert(withdrawn_.end(), loops.begin(), loops.end());
    is_doubt_called_ = true;
    solver_.goOnWith(std::move(before));
  }
  moveRetired();
}

const graph::SolveReport& BackEnd::solve() {
  if (doubt_) {
    concludeDoubt();
  }
  report_ = solver_.finish();
  if (is_doubt_called_ || isAnyLoopFarOff()) {
    beginDoubt();
    concludeDoubt();
  }
  moveRetired();
  return report_;
}

bool BackEnd::isAnyLoopFarOff() const {
  const auto& constraints = graph().constraints;
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    if (constraints[k].kind == graph::ConstraintKind::kLoop &&
        graph::chiSquare(graph(), constraints[k]) > limitOf(k)) {
      return true;
    }
  }
  return false;
}

double BackEnd::limitOf(std::size_t k) const {
  const double gate = config_.doubt.gate * config_.doubt.gate;
  const double let_be = k < let_be_.size() ? let_be_[k] : 0.0;
  return let_be > gate ? kWorse * let_be : gate;
}

void BackEnd::beginDoubt() {
  ++doubts_;
  doubted_at_ = graph().poses.size();
  is_doubt_called_ = false;
  const auto isIdle = [this](const Constraint& loop) {  // its keyframes go together by now
    const Constraint carried = retired_.carried(loop);
    return carried.from == carried.to;
  };
  const auto first = std::stable_partition(withdrawn_.begin(), withdrawn_.end(), isIdle);
  std::transform(first, withdrawn_.end(), first,
                 [this](const Constraint& loop) { return retired_.carried(loop); });
  doubt_.emplace(graph(), withdrawn_, static_cast<std::size_t>(first - withdrawn_.begin()),
                 config_.doubt, isLarge() ? confirmed_ : std::nullopt);
}

void BackEnd::concludeDoubt() {
  graph::PoseGraph doubted = graph();
  confirmed_ = doubt_->conclude(doubted, withdrawn_);
  doubt_.reset();
  if (confirmed_) {
    report_ = solver_.resume(std::move(doubted));
  }
  letBe();
}

void BackEnd::letBe() {
  let_be_.clear();
  for (const Constraint& constraint : graph().constraints) {
    let_be_.push_back(graph::chiSquare(graph(), constraint));
  }
}

/// Constraints are folded together where the graph is at rest.
void BackEnd::retireSome() {
  looked_at_ = graph().poses.size();
  if (config_.thinning.nodes_per_place == 0 || !graph::isAnyCrowded(graph(), config_.thinning)) {
    return;
  }
  if (isLarge()) {
    report_ = solver_.finish();
    is_doubt_called_ = is_doubt_called_ || isAnyLoopFarOff();
  } else {
    solve();
  }
  graph::PoseGraph thinned = graph();
  const std::vector<graph::Retirement> newly = graph::retireNodes(thinned, config_.thinning);
  if (newly.empty()) {
    return;
  }
  for (const graph::Retirement& retirement : newly) {
    retired_.add(retirement);
  }
  std::copy_if(graph().constraints.begin(), graph().constraints.end(), std::back_inserter(folded_),
               [this](const Constraint& c) {
                 return c.kind == graph::ConstraintKind::kLoop &&
                        (retired_.has(c.from) || retired_.has(c.to));
               });
  solver_.goOnWith(std::move(thinned));
  letBe();
  moveRetired();
}

void BackEnd::moveRetired() {
  retired_.follow(graph().poses, [this](NodeId node, const Pose2& T_map_node) {
    solver_.place(node, T_map_node);
  });
}

BeliefAccount BackEnd::beliefs() const {
  BeliefAccount account{{}, withdrawn_, folded_};
  account.weights.reserve(graph().constraints.size());
  for (const Constraint& constraint : graph().constraints) {
    const graph::RobustKernel& kernel = config_.graph.solver.kernels.of(constraint.kind);
    account.weights.push_back(kernel.at(graph::chiSquare(graph(), constraint)).weight);
  }
  return account;
}

Pose2 BackEnd::mapFromOdometry() const {
  return graph().poses.empty() ? Pose2{} : graph().poses.back() * T_odom_newest_.inverse();
}

void BackEnd::reset() { *this = BackEnd(config_); }

}  // namespace omega_slam::slam

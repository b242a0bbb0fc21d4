#include "omega_slam/slam/back_end.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::slam {

using geometry::Pose2;
using graph::Constraint;
using graph::NodeId;

namespace {

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
  violations.include("solver", solver.validate());
  violations.requireAtLeast("solve_error", solve_error, 0.0);
  violations.requireAtLeast("solve_interval", solve_interval, 1);
  return violations.sentences();
}

BackEnd::BackEnd(const BackEndConfig& config) : config_(config) {
  geometry::throwIfAny(config_.validate());
}

std::string BackEnd::addKeyframe(NodeId id, const Pose2& T_odom_base,
                                 const std::vector<Constraint>& constraints) {
  if (id != graph_.poses.size()) {
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
  graph_.poses.emplace_back();
  if (id > 0) {
    graph_.poses[id] = placeByBest(graph_, id, valid);
    graph_.poses[id] = graph::relaxNode(graph_, id, valid);
  }
  graph_.constraints.insert(graph_.constraints.end(), valid.begin(), valid.end());
  T_odom_newest_ = T_odom_base;
  return {};
}

std::string BackEnd::addConstraints(const std::vector<Constraint>& constraints) {
  std::string refusal;
  for (const Constraint& constraint : constraints) {
    const std::string fault = graph::faultOf(constraint, graph_.poses.size());
    if (!fault.empty()) {
      refusal = refusal.empty() ? fault : refusal;
      continue;
    }
    if (!unsolved_) {
      unsolved_ = true;
      unsolved_since_ = graph_.poses.size();
    }
    unsolved_error_ = std::max(unsolved_error_, std::sqrt(graph::chiSquare(graph_, constraint)));
    graph_.constraints.push_back(constraint);
  }
  return refusal;
}

bool BackEnd::wantsSolve() const {
  const std::size_t waited = graph_.poses.size() - unsolved_since_;
  return unsolved_ && (unsolved_error_ > config_.solve_error ||
                       waited >= static_cast<std::size_t>(config_.solve_interval));
}

const graph::SolveReport& BackEnd::solve() {
  report_ = graph::solve(graph_, config_.solver);
  unsolved_ = false;
  unsolved_error_ = 0.0;
  return report_;
}

Pose2 BackEnd::mapFromOdometry() const {
  return graph_.poses.empty() ? Pose2{} : graph_.poses.back() * T_odom_newest_.inverse();
}

void BackEnd::reset() { *this = BackEnd(config_); }

}  // namespace omega_slam::slam

#include "omega_slam/graph/neighbourhood.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/constraints_by_node.h"

namespace omega_slam::graph {

using geometry::angleDifference;

namespace {

constexpr NodeId kNone = static_cast<NodeId>(-1);

/// [m] How far the rest may lie: what a turn moves it by.
constexpr double kArm = 20.0;

}  // namespace

Neighbourhood::Neighbourhood(const PoseGraph& whole, const std::vector<Constraint>& around,
                             int reach)
    : numbers_(whole.poses.size(), kNone), reach_(reach) {
  for (const Constraint& constraint : around) {
    reachFor(constraint.from, 0);
    reachFor(constraint.to, 0);
  }
  grow(whole, reach);
}

void Neighbourhood::reachFor(NodeId node, int steps) {
  if (numbers_[node] == kNone) {
    numbers_[node] = static_cast<NodeId>(nodes_.size());
    nodes_.push_back(node);
    steps_.push_back(steps);
  }
}

/// Breadth first. What ties nodes of the rim to each other moves nothing, and is left out.
void Neighbourhood::grow(const PoseGraph& whole, int reach) {
  const ConstraintsByNode ties(whole);
  for (std::size_t i = 0; i < nodes_.size() && steps_[i] < reach; ++i) {
    ties.forEach(nodes_[i], [&](std::size_t k) {
      const Constraint& constraint = whole.constraints[k];
      const NodeId other = constraint.from == nodes_[i] ? constraint.to : constraint.from;
      reachFor(other, steps_[i] + 1);
      touched_.push_back(k);
    });
  }
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
}

PoseGraph Neighbourhood::of(const PoseGraph& whole) const {
  PoseGraph part;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    part.poses.push_back(whole.poses[nodes_[i]]);
    if (steps_[i] == reach_) {
      part.held.push_back(static_cast<NodeId>(i));
    }
  }
  part.constraints.reserve(touched_.size());
  for (const std::size_t k : touched_) {
    part.constraints.push_back(whole.constraints[k]);
    part.constraints.back().from = numbers_[whole.constraints[k].from];
    part.constraints.back().to = numbers_[whole.constraints[k].to];
  }
  const auto pick = [this](const std::vector<NodeId>& from, std::vector<NodeId>& to) {
    for (const NodeId node : from) {
      const NodeId number = numbers_[node];
      if (number != kNone && std::find(to.begin(), to.end(), number) == to.end()) {
        to.push_back(number);
      }
    }
  };
  pick(whole.held.empty() ? std::vector<NodeId>{0} : whole.held, part.held);
  pick(whole.points, part.points);
  return part;
}

double Neighbourhood::outerMotion(const PoseGraph& part, const PoseGraph& whole) const {
  double most = 0.0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const geometry::Pose2& before = whole.poses[nodes_[i]];
    if (2 * steps_[i] >= reach_) {
      most = std::max({most, distance(part.poses[i], before),
                       kArm * std::abs(angleDifference(part.poses[i].theta, before.theta))});
    }
  }
  return most;
}

void Neighbourhood::place(const PoseGraph& part, PoseGraph& whole) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    whole.poses[nodes_[i]] = part.poses[i];
  }
}

}  // namespace omega_slam::graph

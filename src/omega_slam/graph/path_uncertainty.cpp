#include "omega_slam/graph/path_uncertainty.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "omega_slam/geometry/covariance.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

constexpr double kArm = 2.0;                // [m] at which a turn counts
constexpr double kLeastDeterminant = 1e-9;  // of an information that can be inverted
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a constraint costs a path: of its covariance, the inverse, no more than the diagonal.
double costOf(const Constraint& constraint) {
  const Eigen::Matrix3d& i = constraint.information;
  const double xx = i(1, 1) * i(2, 2) - i(1, 2) * i(1, 2);
  const double yy = i(0, 0) * i(2, 2) - i(0, 2) * i(0, 2);
  const double tt = i(0, 0) * i(1, 1) - i(0, 1) * i(0, 1);
  const double determinant = i.determinant();
  return std::abs(determinant) > kLeastDeterminant ? (xx + yy + kArm * kArm * tt) / determinant
                                                   : kInfinity;
}

/// The covariance of a constraint as that of the step from one of its nodes to the other, in the
/// axes of the first.
Eigen::Matrix3d covarianceOfStep(const PoseGraph& graph, const Constraint& constraint,
                                 NodeId first) {
  const Eigen::Matrix3d covariance = constraint.information.inverse();
  if (first == constraint.from) {
    return geometry::rotateCovariance(covariance, constraint.T_from_to.theta);
  }
  // Seen from `to`, an error of the pose moves the place of `from` by the arm to it.
  const Pose2 T_to_from = relativePose(graph.poses[constraint.to], graph.poses[constraint.from]);
  Eigen::Matrix3d moved = Eigen::Matrix3d::Identity();
  moved(0, 2) = -T_to_from.y;
  moved(1, 2) = T_to_from.x;
  return moved * covariance * moved.transpose();
}

}  // namespace

PathUncertainty::PathUncertainty(const PoseGraph& graph, NodeId root)
    : graph_(graph),
      root_(root),
      T_root_graph_(graph.poses[root].inverse()),
      arrivals_(graph.poses.size(), Arrival{kInfinity}),
      covariances_(graph.poses.size()),
      is_compounded_(graph.poses.size(), false) {
  listSteps();
  arrivals_[root].cost = 0.0;
  arrivals_[root].before = root;
  open_.emplace(0.0, root);
  covariances_[root].setZero();
  is_compounded_[root] = true;
}

void PathUncertainty::listSteps() {
  first_steps_.assign(graph_.poses.size() + 1, 0);
  for (const Constraint& constraint : graph_.constraints) {
    ++first_steps_[constraint.from + 1];
    ++first_steps_[constraint.to + 1];
  }
  std::partial_sum(first_steps_.begin(), first_steps_.end(), first_steps_.begin());
  steps_.resize(2 * graph_.constraints.size());
  std::vector<std::size_t> next(first_steps_.begin(), first_steps_.end() - 1);
  for (std::size_t k = 0; k < graph_.constraints.size(); ++k) {
    const Constraint& constraint = graph_.constraints[k];
    const auto index = static_cast<std::uint32_t>(k);
    const double cost = costOf(constraint);
    steps_[next[constraint.from]++] = {constraint.to, index, cost};
    steps_[next[constraint.to]++] = {constraint.from, index, cost};
  }
}

/// Goes on with Dijkstra's search until the surest path to a node is known, or no path is left.
void PathUncertainty::settle(NodeId node) {
  while (arrivals_[node].hops < 0 && !open_.empty()) {
    const auto [cost, at] = open_.top();
    open_.pop();
    Arrival& here = arrivals_[at];
    if (here.hops >= 0) {
      continue;
    }
    here.hops = here.before == at ? 0 : arrivals_[here.before].hops + 1;
    for (std::size_t s = first_steps_[at]; s < first_steps_[at + 1]; ++s) {
      const Step& step = steps_[s];
      const double total = cost + step.cost;
      Arrival& there = arrivals_[step.node];
      if (there.hops < 0 && total < there.cost) {
        there = {total, -1, at, step.constraint};
        open_.emplace(total, step.node);
      }
    }
  }
}

int PathUncertainty::hops(NodeId node) {
  settle(node);
  return arrivals_[node].hops;
}

const Eigen::Matrix3d& PathUncertainty::covariance(NodeId node) {
  settle(node);
  std::vector<NodeId> unknown;  // the way back to what is known
  for (NodeId at = node; !is_compounded_[at]; at = arrivals_[at].before) {
    unknown.push_back(at);
  }
  std::for_each(unknown.rbegin(), unknown.rend(), [this](NodeId at) { compound(at); });
  return covariances_[node];
}

/// @param node that the one before it on its path is known of
void PathUncertainty::compound(NodeId node) {
  const NodeId before = arrivals_[node].before;
  const Constraint& constraint = graph_.constraints[arrivals_[node].constraint];
  const std::vector<Pose2>& poses = graph_.poses;
  covariances_[node] = geometry::composeCovariance(
      T_root_graph_ * poses[before], covariances_[before], relativePose(poses[before], poses[node]),
      covarianceOfStep(graph_, constraint, before));
  is_compounded_[node] = true;
}

double PathUncertainty::placeDeviation(NodeId node) {
  if (!reaches(node)) {
    return kInfinity;
  }
  const Eigen::Matrix3d& known = covariance(node);
  const double mean = 0.5 * (known(0, 0) + known(1, 1));
  const double half = 0.5 * (known(0, 0) - known(1, 1));
  return std::sqrt(mean + std::hypot(half, known(0, 1)));
}

double PathUncertainty::headingDeviation(NodeId node) {
  return reaches(node) ? std::sqrt(covariance(node)(2, 2)) : kInfinity;
}

}  // namespace omega_slam::graph

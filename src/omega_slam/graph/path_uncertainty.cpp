#include "omega_slam/graph/path_uncertainty.h"

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>

#include "omega_slam/geometry/covariance.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

constexpr double kArm = 2.0;                // [m] at which a turn counts
constexpr double kLeastDeterminant = 1e-9;  // of an information that can be inverted
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A constraint as a step between its nodes, in either direction.
struct Step {
  NodeId node{0};  ///< that it leads to
  std::size_t constraint{0};
};

/// Steps from each node, one after the other: those of node i are [begin[i], begin[i + 1]).
struct Steps {
  std::vector<std::size_t> begin;
  std::vector<Step> steps;
};

Steps stepsOf(const PoseGraph& graph) {
  Steps all;
  all.begin.assign(graph.poses.size() + 1, 0);
  for (const Constraint& constraint : graph.constraints) {
    ++all.begin[constraint.from + 1];
    ++all.begin[constraint.to + 1];
  }
  for (std::size_t node = 0; node < graph.poses.size(); ++node) {
    all.begin[node + 1] += all.begin[node];
  }
  all.steps.resize(2 * graph.constraints.size());
  std::vector<std::size_t> next(all.begin.begin(), all.begin.end() - 1);
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    const Constraint& constraint = graph.constraints[k];
    all.steps[next[constraint.from]++] = {constraint.to, k};
    all.steps[next[constraint.to]++] = {constraint.from, k};
  }
  return all;
}

/// Covariances in the axes of `to`, and what they cost a path.
struct Price {
  Eigen::Matrix3d covariance;
  double cost{kInfinity};
};

std::vector<Price> pricesOf(const PoseGraph& graph) {
  std::vector<Price> prices(graph.constraints.size());
  for (std::size_t k = 0; k < prices.size(); ++k) {
    const Eigen::Matrix3d& information = graph.constraints[k].information;
    if (information.determinant() > kLeastDeterminant) {
      Price& price = prices[k];
      price.covariance = information.inverse();
      const double turn = price.covariance(2, 2);
      price.cost = price.covariance.topLeftCorner<2, 2>().trace() + kArm * kArm * turn;
    }
  }
  return prices;
}

/// The covariance of a constraint as that of the step from one of its nodes to the other, in the
/// axes of the first.
Eigen::Matrix3d covarianceOfStep(const PoseGraph& graph, const Constraint& constraint,
                                 const Eigen::Matrix3d& covariance, NodeId first) {
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
    : hops_(graph.poses.size(), -1), covariances_(graph.poses.size(), Eigen::Matrix3d::Zero()) {
  const Steps all = stepsOf(graph);
  const std::vector<Price> prices = pricesOf(graph);
  // Cost, node, constraint that leads there and node that it comes from.
  using Path = std::tuple<double, NodeId, std::size_t, NodeId>;
  std::priority_queue<Path, std::vector<Path>, std::greater<>> open;
  std::vector<double> least(graph.poses.size(), kInfinity);
  least[root] = 0.0;
  open.emplace(0.0, root, 0, root);
  while (!open.empty()) {
    const auto [cost, node, by, before] = open.top();
    open.pop();
    if (hops_[node] >= 0) {
      continue;
    }
    hops_[node] = node == root ? 0 : hops_[before] + 1;
    if (node != root) {
      const Eigen::Matrix3d step =
          covarianceOfStep(graph, graph.constraints[by], prices[by].covariance, before);
      covariances_[node] = geometry::composeCovariance(
          relativePose(graph.poses[root], graph.poses[before]), covariances_[before],
          relativePose(graph.poses[before], graph.poses[node]), step);
    }
    for (std::size_t s = all.begin[node]; s < all.begin[node + 1]; ++s) {
      const Step& step = all.steps[s];
      const double total = cost + prices[step.constraint].cost;
      if (total < least[step.node]) {
        least[step.node] = total;
        open.emplace(total, step.node, step.constraint, node);
      }
    }
  }
}

double PathUncertainty::placeDeviation(NodeId node) const {
  if (!reaches(node)) {
    return kInfinity;
  }
  const Eigen::Matrix3d& covariance = covariances_[node];
  const double mean = 0.5 * (covariance(0, 0) + covariance(1, 1));
  const double half = 0.5 * (covariance(0, 0) - covariance(1, 1));
  return std::sqrt(mean + std::hypot(half, covariance(0, 1)));
}

double PathUncertainty::headingDeviation(NodeId node) const {
  return reaches(node) ? std::sqrt(covariances_[node](2, 2)) : kInfinity;
}

}  // namespace omega_slam::graph

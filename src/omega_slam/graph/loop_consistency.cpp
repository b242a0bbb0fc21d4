#include "omega_slam/graph/loop_consistency.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "omega_slam/geometry/covariance.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

constexpr double kVague = 1e-9;  // of the information's trace, where it says nothing

Eigen::Matrix3d carry(const Pose2& T_a_b, const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix3d along = geometry::adjoint(T_a_b);
  return along * covariance * along.transpose();
}

/// Of the error as a twist in the frame of `to`.
Eigen::Matrix3d covarianceOf(const Constraint& constraint) {
  const Eigen::Matrix3d& information = constraint.information;
  return (information + kVague * information.trace() * Eigen::Matrix3d::Identity()).inverse();
}

/// A loop as seen from its earlier node.
struct Forward {
  explicit Forward(const Constraint& loop)
      : low(loop.from), high(loop.to), T_low_high(loop.T_from_to), covariance(covarianceOf(loop)) {
    if (low > high) {
      std::swap(low, high);
      covariance = carry(loop.T_from_to, covariance);
      T_low_high = T_low_high.inverse();
    }
  }

  NodeId low;
  NodeId high;
  Pose2 T_low_high;
  Eigen::Matrix3d covariance;  ///< of a twist in the frame of `high`
};

NodeId gap(NodeId a, NodeId b) { return std::max(a, b) - std::min(a, b); }

std::vector<const Constraint*> stepsOf(const PoseGraph& graph) {
  std::vector<const Constraint*> steps(graph.poses.size(), nullptr);
  for (const Constraint& constraint : graph.constraints) {
    if (constraint.kind == ConstraintKind::kLoop || gap(constraint.from, constraint.to) != 1) {
      continue;
    }
    const Constraint*& best = steps[std::max(constraint.from, constraint.to)];
    if (best == nullptr || constraint.information.determinant() > best->information.determinant()) {
      best = &constraint;
    }
  }
  return steps;
}

}  // namespace

OdometryChain::OdometryChain(const PoseGraph& graph)
    : poses_(graph.poses.size()),
      covariances_(graph.poses.size(), Eigen::Matrix3d::Zero()),
      parts_(graph.poses.size(), 0) {
  const auto steps = stepsOf(graph);
  for (std::size_t i = 1; i < poses_.size(); ++i) {
    const Constraint* step = steps[i];
    parts_[i] = parts_[i - 1] + (step == nullptr ? 1 : 0);
    if (step != nullptr) {
      poses_[i] = poses_[i - 1] * (step->to == i ? step->T_from_to : step->T_from_to.inverse());
      covariances_[i] = covariances_[i - 1] + carry(poses_[step->to], covarianceOf(*step));
    }
  }
}

std::optional<double> OdometryChain::disagreement(const Constraint& a, const Constraint& b) const {
  const Forward one(a);
  const Forward other(b);
  if (parts_[one.low] != parts_[other.low] || parts_[one.high] != parts_[other.high]) {
    return std::nullopt;
  }
  const auto covarianceBetween = [this](NodeId i, NodeId k) -> Eigen::Matrix3d {
    return covariances_[std::max(i, k)] - covariances_[std::min(i, k)];
  };
  // one.low -> other.low -> other.high -> one.high, which should be one.T_low_high.
  const Pose2 first = relativePose(poses_[one.low], poses_[other.low]);
  const Pose2 last = relativePose(poses_[other.high], poses_[one.high]);
  const Pose2 cycle = one.T_low_high.inverse() * first * other.T_low_high * last;
  const Pose2 T_high_origin = poses_[one.high].inverse();
  const Pose2 T_high_start = (poses_[other.low] * other.T_low_high * last).inverse();
  const Eigen::Matrix3d covariance = one.covariance + carry(last.inverse(), other.covariance) +
                                     carry(T_high_origin, covarianceBetween(one.high, other.high)) +
                                     carry(T_high_start, covarianceBetween(one.low, other.low));
  const Eigen::Vector3d error = cycle.vector();
  return error.dot(covariance.ldlt().solve(error));
}

NodeId OdometryChain::separation(const Constraint& a, const Constraint& b) {
  const auto [a_low, a_high] = std::minmax(a.from, a.to);
  const auto [b_low, b_high] = std::minmax(b.from, b.to);
  return std::max(gap(a_low, b_low), gap(a_high, b_high));
}

LoopSupport supportOf(const Constraint& loop, const std::vector<Constraint>& others,
                      const OdometryChain& chain, const SupportConfig& config) {
  LoopSupport support;
  for (const Constraint& other : others) {
    if (OdometryChain::separation(loop, other) > config.neighbourhood) {
      continue;
    }
    if (const auto squared = chain.disagreement(loop, other)) {
      ++(*squared < config.gate * config.gate ? support.agreeing : support.disagreeing);
    }
  }
  return support;
}

std::vector<std::vector<std::size_t>> agreeingLoops(const PoseGraph& graph,
                                                    const std::vector<std::size_t>& loops,
                                                    const SupportConfig& config) {
  const OdometryChain chain(graph);
  const auto loopAt = [&](std::size_t i) -> const Constraint& {
    return graph.constraints[loops[i]];
  };
  const auto low = [&](std::size_t i) { return std::min(loopAt(i).from, loopAt(i).to); };
  std::vector<std::size_t> order(loops.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return low(i) < low(j); });
  std::vector<std::vector<std::size_t>> agreeing(loops.size());
  for (auto i = order.begin(); i != order.end(); ++i) {
    for (auto j = i + 1; j != order.end() && low(*j) - low(*i) <= config.neighbourhood; ++j) {
      if (OdometryChain::separation(loopAt(*i), loopAt(*j)) > config.neighbourhood) {
        continue;
      }
      const auto squared = chain.disagreement(loopAt(*i), loopAt(*j));
      if (squared && *squared < config.gate * config.gate) {
        agreeing[*i].push_back(*j);
        agreeing[*j].push_back(*i);
      }
    }
  }
  for (auto& others : agreeing) {
    std::sort(others.begin(), others.end());
  }
  return agreeing;
}

}  // namespace omega_slam::graph

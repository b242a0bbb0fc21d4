#include "omega_slam/evaluation/trajectory_error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "omega_slam/evaluation/rigid_fit.h"
#include "omega_slam/geometry/angle.h"

namespace omega_slam::evaluation {
namespace {

using geometry::Pose2;
using geometry::StampedPose2;
using geometry::Trajectory;

/// A pose of the estimate and the truth at the same time.
struct Pair {
  Pose2 estimate;
  Pose2 truth;
};

/// @param truth in the order of time
std::optional<Pose2> truthAt(const Trajectory& truth, double stamp, double max_gap) {
  const auto next =
      std::lower_bound(truth.begin(), truth.end(), stamp,
                       [](const StampedPose2& pose, double value) { return pose.stamp < value; });
  if (next == truth.end()) {
    return std::nullopt;
  }
  if (next->stamp == stamp) {
    return next->pose;
  }
  if (next == truth.begin() || next->stamp - std::prev(next)->stamp > max_gap) {
    return std::nullopt;
  }
  const StampedPose2& before = *std::prev(next);
  return geometry::interpolate(before.pose, next->pose,
                               (stamp - before.stamp) / (next->stamp - before.stamp));
}

std::vector<Pair> pairUp(const Trajectory& estimate, Trajectory truth, double max_gap) {
  std::stable_sort(truth.begin(), truth.end(),
                   [](const StampedPose2& a, const StampedPose2& b) { return a.stamp < b.stamp; });
  std::vector<Pair> pairs;
  for (const StampedPose2& entry : estimate) {
    if (const auto true_pose = truthAt(truth, entry.stamp, max_gap)) {
      pairs.push_back({entry.pose, *true_pose});
    }
  }
  return pairs;
}

Pose2 fit(const std::vector<Pair>& pairs) {
  std::vector<PointPair> points;
  Eigen::Vector2d heading = Eigen::Vector2d::Zero();
  for (const Pair& pair : pairs) {
    points.push_back({pair.estimate.translation(), pair.truth.translation()});
    const double turn = geometry::angleDifference(pair.truth.theta, pair.estimate.theta);
    heading += Eigen::Vector2d(std::cos(turn), std::sin(turn));
  }
  return fitRigidMotion(points, std::atan2(heading.y(), heading.x()));
}

}  // namespace

TrajectoryError absoluteTrajectoryError(const Trajectory& estimate, const Trajectory& truth,
                                        double max_gap) {
  const std::vector<Pair> pairs = pairUp(estimate, truth, max_gap);
  TrajectoryError error;
  error.matched = pairs.size();
  error.unmatched = estimate.size() - pairs.size();
  if (pairs.empty()) {
    return error;
  }
  error.T_truth_map = fit(pairs);
  std::vector<double> translations;
  std::vector<double> rotations;
  for (const Pair& pair : pairs) {
    const Pose2 fitted = error.T_truth_map * pair.estimate;
    translations.push_back(geometry::distance(fitted, pair.truth));
    rotations.push_back(std::abs(geometry::angleDifference(fitted.theta, pair.truth.theta)));
  }
  error.translation = summarize(translations);
  error.rotation = summarize(rotations);
  return error;
}

}  // namespace omega_slam::evaluation

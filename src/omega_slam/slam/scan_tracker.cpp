#include "omega_slam/slam/scan_tracker.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/covariance.h"

namespace omega_slam::slam {

using geometry::Pose2;

namespace {

/// Of a match's covariance, which is a bound: errors of tracking are far smaller, and since the map
/// is made of such matches, a filter that trusts the odometry more lets its bias into the map.
constexpr double kMatchShare = 0.1;

/// Squared Mahalanobis distance beyond which the odometry of a step has slipped: chance lets one
/// step in a hundred thousand come so far.
constexpr double kSlip = 25.0;

// Of the scale of the odometry's variances.
constexpr double kLeastScale = 0.25;
constexpr double kMostScale = 100.0;
constexpr double kLearningRate = 0.02;  // a scan's share

Belief predict(const Belief& before, const OdometryStep& step, double scale) {
  return {before.pose * step.motion,
          geometry::composeCovariance(before.pose, before.covariance, step.motion,
                                      scale * step.covariance)};
}

Eigen::Vector3d differenceOf(const Pose2& a, const Pose2& b) {
  return {a.x - b.x, a.y - b.y, geometry::angleDifference(a.theta, b.theta)};
}

}  // namespace

ScanTracker::ScanTracker(const matching::MatcherConfig& matching, double min_confidence)
    : min_confidence_(min_confidence),
      matcher_(matching::makeMatcher(matching)),
      map_matcher_(dynamic_cast<const matching::MapMatcher*>(matcher_.get())) {}

matching::MatchResult ScanTracker::match(const matching::LocalMap& map, const matching::View& scan,
                                         const Pose2& guess) const {
  return map_matcher_ != nullptr ? map_matcher_->track(map, scan, guess)
                                 : matcher_->match(map.recentViews(), scan, guess);
}

TrackedScan ScanTracker::track(const matching::LocalMap& map, const matching::View& scan,
                               const Belief& before, const OdometryStep& step) {
  const Belief predicted = predict(before, step, scale_);
  TrackedScan tracked;
  tracked.match = match(map, scan, predicted.pose);
  tracked.is_trusted = tracked.match.confidence >= min_confidence_;
  tracked.belief = predicted;
  if (!tracked.is_trusted) {
    return tracked;
  }

  const Belief matched{tracked.match.T_reference_scan, kMatchShare * tracked.match.covariance};
  const Eigen::Vector3d innovation = differenceOf(matched.pose, predicted.pose);
  const Eigen::Matrix3d spread = predicted.covariance + matched.covariance;
  const Eigen::LDLT<Eigen::Matrix3d> solver(spread);
  const double squared = innovation.dot(solver.solve(innovation));
  tracked.has_slipped = squared > kSlip;
  learn(innovation, spread);
  if (tracked.has_slipped) {
    tracked.belief = matched;
    return tracked;
  }
  const Eigen::Matrix3d gain = predicted.covariance * solver.solve(Eigen::Matrix3d::Identity());
  tracked.belief.pose = Pose2::fromVector(predicted.pose.vector() + gain * innovation);
  const Eigen::Matrix3d rest = (Eigen::Matrix3d::Identity() - gain) * predicted.covariance;
  tracked.belief.covariance = 0.5 * (rest + rest.transpose());
  return tracked;
}

void ScanTracker::learn(const Eigen::Vector3d& innovation, const Eigen::Matrix3d& covariance) {
  const double squared = innovation.dot(covariance.ldlt().solve(innovation)) / 3.0;
  scale_ *= std::exp(kLearningRate * (std::min(squared, 4.0) - 1.0));
  scale_ = std::clamp(scale_, kLeastScale, kMostScale);
}

}  // namespace omega_slam::slam

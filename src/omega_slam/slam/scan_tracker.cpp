#include "omega_slam/slam/scan_tracker.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "omega_slam/geometry/covariance.h"
#include "omega_slam/matching/map_evidence.h"
#include "omega_slam/matching/sight_check.h"

namespace omega_slam::slam {

using geometry::Pose2;

namespace {

/// Of a match's covariance, which is a bound: errors of tracking are far smaller, and since the map
/// is made of such matches, a filter that trusts the odometry more lets its bias into the map.
constexpr double kMatchShare = 0.1;

/// Squared Mahalanobis distance beyond which prediction and match contradict each other: three
/// deviations.
constexpr double kApart = 9.0;

/// By which factor a scan fits worse where it was predicted, if that was wrong.
constexpr double kClearly = 1.3;

// A scan with less confidence than this, and of which more lies where the map knows that nothing
// is, or sees more through the walls of the scan before, was not taken there.
constexpr double kUnsure = 0.7;
constexpr double kMostContradiction = 0.2;

/// How far around odometry that was wrong a scan is looked for.
constexpr matching::SearchWindow kRecovery{1.5, 3.15};

Belief predict(const Belief& before, const OdometryStep& step) {
  return {before.pose * step.motion, geometry::composeCovariance(before.pose, before.covariance,
                                                                 step.motion, step.covariance)};
}

/// Kalman update.
Belief fuse(const Belief& predicted, const Belief& matched) {
  const Eigen::LDLT<Eigen::Matrix3d> spread(predicted.covariance + matched.covariance);
  const Eigen::Matrix3d gain = predicted.covariance * spread.solve(Eigen::Matrix3d::Identity());
  const Eigen::Vector3d innovation = differenceOf(matched.pose, predicted.pose);
  const Eigen::Matrix3d rest = (Eigen::Matrix3d::Identity() - gain) * predicted.covariance;
  return {Pose2::fromVector(predicted.pose.vector() + gain * innovation),
          0.5 * (rest + rest.transpose())};
}

}  // namespace

ScanTracker::ScanTracker(const matching::MatcherConfig& matching, double min_confidence,
                         const PlaceMatcherConfig& places)
    : min_confidence_(min_confidence),
      match_config_(matching.match),
      places_(places),
      matcher_(matching::makeMatcher(matching)),
      map_matcher_(dynamic_cast<const matching::MapMatcher*>(matcher_.get())) {}

matching::MatchResult ScanTracker::match(const matching::LocalMap& map, const matching::View& scan,
                                         const Pose2& guess) const {
  return map_matcher_ != nullptr ? map_matcher_->track(map, scan, guess)
                                 : matcher_->match(map.recentViews(), scan, guess);
}

bool ScanTracker::isContradicted(const matching::LocalMap& map, const matching::View& scan,
                                 const matching::MatchResult& match) const {
  if (match.confidence >= kUnsure || map.recentViews().empty()) {
    return false;
  }
  const Pose2& pose = match.T_reference_scan;
  const auto sight =
      matching::checkSightBothWays(map.recentViews().back(), matching::transformed(pose, scan));
  return sight.contradiction() > kMostContradiction ||
         matching::contradictionOf(map, scan.points, pose) > kMostContradiction;
}

bool ScanTracker::fitsBetter(const matching::LocalMap& map, const matching::View& scan,
                             const matching::MatchResult& match, const Pose2& elsewhere) const {
  const auto there = matching::judgeOnMap(map, scan.points, elsewhere, match_config_);
  return kClearly * (1.0 - match.confidence) < 1.0 - there.confidence;
}

TrackedScan ScanTracker::track(const matching::LocalMap& map, const matching::View& scan,
                               const Belief& before, const OdometryStep& step) const {
  const Belief predicted = predict(before, step);
  TrackedScan tracked;
  tracked.predicted = predicted;
  tracked.belief = predicted;
  tracked.match = match(map, scan, predicted.pose);
  tracked.is_contradicted = isContradicted(map, scan, tracked.match);
  tracked.is_trusted = !tracked.is_contradicted && tracked.match.confidence >= min_confidence_;
  if (!tracked.is_trusted) {
    return tracked;
  }

  Belief matched{tracked.match.T_reference_scan, kMatchShare * tracked.match.covariance};
  tracked.matched = matched;
  const Eigen::Vector3d innovation = differenceOf(matched.pose, predicted.pose);
  const double squared = squaredDistance(predicted, matched);
  if (squared > kApart) {
    tracked.has_slipped = fitsBetter(map, scan, tracked.match, predicted.pose);
    if (tracked.has_slipped) {
      // The step was wrong by as much as that. What the match does not know, it still does not.
      const Eigen::Matrix3d slip = innovation * innovation.transpose();
      tracked.belief = fuse({predicted.pose, predicted.covariance + slip},
                            {matched.pose, tracked.match.covariance});
      return tracked;
    }
    matched.covariance *= squared / kApart;
  }
  tracked.belief = fuse(predicted, matched);
  return tracked;
}

TrackedScan ScanTracker::recover(const matching::LocalMap& map, const matching::View& scan,
                                 const TrackedScan& tracked) const {
  const auto found = places_.match(map.recentViews(), scan, tracked.belief.pose, kRecovery);
  if (!found) {
    return tracked;
  }
  TrackedScan recovered;
  recovered.predicted = tracked.predicted;
  recovered.match = *found;
  recovered.matched = {found->T_reference_scan, found->covariance};
  recovered.belief = recovered.matched;
  recovered.is_trusted = true;
  recovered.has_slipped = true;
  return recovered;
}

}  // namespace omega_slam::slam

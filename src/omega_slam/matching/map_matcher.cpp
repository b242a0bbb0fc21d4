#include "omega_slam/matching/map_matcher.h"

#include <utility>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"
#include "omega_slam/matching/map_alignment.h"
#include "omega_slam/matching/map_evidence.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

/// A pose put back to the guess along a direction that nothing determines (Zhang, Kaess and Singh
/// 2016, "On degeneracy of optimization-based state estimation problems", ICRA).
/// @param direction unit vector along (x, y, theta * 1 m)
Pose2 holdAlong(const Eigen::Vector3d& direction, const Pose2& pose, const Pose2& guess) {
  const Eigen::Vector3d moved(pose.x - guess.x, pose.y - guess.y,
                              geometry::angleDifference(pose.theta, guess.theta));
  return Pose2::fromVector(pose.vector() - direction.dot(moved) * direction);
}

}  // namespace

std::vector<std::string> MapMatcherConfig::validate() const {
  geometry::Violations violations;
  violations.include("map", map.validate());
  violations.requireAtLeast("max_iterations", max_iterations, 0);
  violations.requireWithin("min_confidence", min_confidence, 0.0, 1.0);
  return violations.sentences();
}

MapMatcher::MapMatcher(const MapMatcherConfig& config, const MatchConfig& common,
                       std::unique_ptr<const ScanMatcher> fallback)
    : config_(config), common_(common), fallback_(std::move(fallback)) {
  geometry::throwIfAny(config_.validate());
  geometry::throwIfAny(common_.validate());
}

MatchResult MapMatcher::match(const Reference& reference, const View& scan,
                              const Pose2& guess) const {
  if (auto refused = refuseHopeless(reference, scan, guess, common_)) {
    return *refused;
  }
  return track(LocalMap(config_.map, reference), scan, guess);
}

MatchResult MapMatcher::track(const LocalMap& map, const View& scan, const Pose2& guess) const {
  // The map's own views need no look: what is not finite has never come in.
  if (auto refused = refuseHopeless({scan}, scan, guess, common_)) {
    return *refused;
  }
  MatchResult result = alignAndJudge(map, scan, guess);
  if (fallback_ == nullptr || result.confidence >= config_.min_confidence) {
    return result;
  }
  const MatchResult found = fallback_->match(map.recentViews(), scan, guess);
  const MatchResult again = alignAndJudge(map, scan, found.T_reference_scan);
  return again.confidence > result.confidence ? again : result;
}

MatchResult MapMatcher::alignAndJudge(const LocalMap& map, const View& scan,
                                      const Pose2& guess) const {
  const auto judge = [&](const Pose2& pose) { return judgeOnMap(map, scan.points, pose, common_); };
  const MapAlignment alignment = alignToMap(map, scan.points, guess, config_.max_iterations);
  MatchResult result = judge(alignment.T_map_scan);
  if (result.open_direction) {
    result = judge(holdAlong(*result.open_direction, alignment.T_map_scan, guess));
  }
  result.converged = alignment.converged;
  if (!result.converged && result.failure == MatchFailure::kNone) {
    result.failure = MatchFailure::kNotConverged;
  }
  return result;
}

}  // namespace omega_slam::matching

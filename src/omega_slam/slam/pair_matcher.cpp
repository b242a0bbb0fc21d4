#include "omega_slam/slam/pair_matcher.h"

#include <cmath>

namespace omega_slam::slam {

using matching::MatchFailure;

namespace {

/// Scans taken farther apart see too little of the same.
constexpr double kFarthest = 1.2;  // [m]

/// Up to which points are drawn to lines at first: what was tracked is off by centimetres.
constexpr double kReach = 0.2;  // [m]

constexpr double kLeastConfidence = 0.6;

/// Squared Mahalanobis distance beyond which a pair contradicts what was tracked. Such pairs are
/// wrong: scans that see one side each of a door frame, say, lie on each other.
constexpr double kApart = 9.0;

/// Of a pair's covariance. Each scan takes part in several pairs, and its errors in all of them.
constexpr double kShared = 4.0;

matching::PointToLineMatcherConfig fromNearby() {
  matching::PointToLineMatcherConfig config;
  config.max_correspondence_distance = kReach;
  return config;
}

bool isUsable(const matching::MatchResult& match) {
  // Along an open direction the covariance says that nothing is known.
  return match.confidence >= kLeastConfidence &&
         (match.failure == MatchFailure::kNone || match.failure == MatchFailure::kDegenerate);
}

}  // namespace

PairMatcher::PairMatcher(const matching::MatchConfig& config)
    : matcher_(fromNearby(), config, kLeastConfidence) {}

std::optional<graph::Constraint> PairMatcher::match(const Keyframe& from, const Keyframe& to,
                                                    const Belief& tracked) const {
  if (std::hypot(tracked.pose.x, tracked.pose.y) > kFarthest) {
    return std::nullopt;
  }
  matching::MatchResult match =
      matcher_.match({viewOf(from.sweep)}, viewOf(to.sweep), tracked.pose);
  if (!isUsable(match)) {
    return std::nullopt;
  }
  match.covariance *= kShared;
  if (squaredDistance({match.T_reference_scan, match.covariance}, tracked) > kApart) {
    return std::nullopt;
  }
  return matchConstraint(from.id, to.id, match, graph::ConstraintKind::kMatch);
}

}  // namespace omega_slam::slam

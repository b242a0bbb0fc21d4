#include "omega_slam/slam/place_matcher.h"

#include <algorithm>

#include "omega_slam/geometry/validation.h"
#include "omega_slam/matching/correlative_matcher.h"
#include "omega_slam/matching/sight_check.h"

namespace omega_slam::slam {

using geometry::Pose2;
using graph::NodeId;
using matching::MatchResult;
using matching::SearchWindow;

namespace {

constexpr double kNarrow = 0.4;         // [m] up to which points are drawn to lines from the guess
constexpr double kWide = 1.0;           // [m]
constexpr double kSearchStep = 0.05;    // [m] of the correlative search
constexpr double kLeastScore = 0.5;     // of the search; what is confident scores far more
constexpr double kMostAmbiguity = 0.9;  // score of a rival, of the best one's

/// Squared errors of point to line matches between visits, over what their covariance says: the
/// place itself is only as true as the graph. (1.4 to 4.3 in four simulated drives, lab and
/// office.)
constexpr double kDoubt = 3.0;

matching::CorrelativeMatcherConfig searchIn(const SearchWindow& window) {
  matching::CorrelativeMatcherConfig config;
  config.window = window;
  config.resolution = kSearchStep;
  config.least_score = kLeastScore;
  config.least_rival = kMostAmbiguity;
  return config;
}

}  // namespace

std::vector<std::string> PlaceMatcherConfig::validate() const {
  geometry::Violations violations;
  violations.requireWithin("min_confidence", min_confidence, 0.0, 1.0);
  violations.requireWithin("max_contradiction", max_contradiction, 0.0, 1.0);
  violations.include("match", match.validate());
  return violations.sentences();
}

bool isWide(const SearchWindow& window) { return window.translation > kWide; }

PlaceMatcher::PlaceMatcher(const PlaceMatcherConfig& config)
    : config_((geometry::throwIfAny(config.validate()), config)),
      nearby_({}, config_.match, config_.min_confidence) {}

std::optional<MatchResult> PlaceMatcher::match(const matching::Reference& place,
                                               const matching::View& scan, const Pose2& guess,
                                               const SearchWindow& window) const {
  MatchResult found;
  bool is_ambiguous = false;
  if (window.translation <= kNarrow) {
    found = nearby_.match(place, scan, guess);
    found.covariance *= kDoubt;
  } else {
    const matching::CorrelativeMatcher search(searchIn(window), config_.match);
    const auto best = search.matchWithPeaks(place, scan, guess, isWide(window) ? 2 : 1);
    found = best.result;
    is_ambiguous = best.peaks.size() > 1;
  }
  if (found.confidence < config_.min_confidence || found.open_direction || is_ambiguous) {
    return std::nullopt;
  }
  const auto sight = matching::checkSightBothWays(
      place.back(), matching::transformed(found.T_reference_scan, scan));
  if (sight.contradiction() > config_.max_contradiction) {
    return std::nullopt;
  }
  return found;
}

std::vector<NodeId> neighboursOf(NodeId center, NodeId reach, const KnownPlaces& known) {
  const NodeId stretch = known.keyframes[center]->stretch;
  const auto end = static_cast<NodeId>(std::min(known.keyframes.size(), known.poses.size()));
  std::vector<NodeId> ids;
  for (NodeId id = beginOfNewest(reach + 1, *known.keyframes[center]);
       id < std::min(center + reach + 1, end) && known.keyframes[id]->stretch == stretch; ++id) {
    ids.push_back(id);
  }
  return ids;
}

matching::Reference placeAround(NodeId center, NodeId reach, const KnownPlaces& known) {
  const auto& [keyframes, poses] = known;
  matching::Reference place;
  for (const NodeId id : neighboursOf(center, reach, known)) {
    if (id != center) {
      const Pose2 T_center_id = relativePose(poses[center], poses[id]);
      place.push_back(matching::transformed(T_center_id, viewOf(keyframes[id]->sweep)));
    }
  }
  place.push_back(viewOf(keyframes[center]->sweep));
  return place;
}

}  // namespace omega_slam::slam

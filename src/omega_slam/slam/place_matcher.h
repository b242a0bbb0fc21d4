#pragma once

#include <optional>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/correlative_search.h"
#include "omega_slam/matching/point_to_line_matcher.h"
#include "omega_slam/matching/scan_matcher.h"
#include "omega_slam/slam/keyframe.h"

namespace omega_slam::slam {

struct PlaceMatcherConfig {
  double min_confidence{0.7};      ///< [0, 1]
  double max_contradiction{0.15};  ///< [0, 1] of points, those that were seen through
  matching::MatchConfig match;

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Whether a window is so wide that other places within it may look like the right one.
[[nodiscard]] bool isWide(const matching::SearchWindow& window);

/// Says whether, and where, a scan was taken at a place that the robot has been to. A wrong answer
/// harms more than none, so that it has to be right:
///
/// - In a narrow window the scan is drawn to the place point to line. In a wider one a correlative
///   search looks at every pose of it first.
/// - The match must be confident and leave no direction open: else it could be any other place
///   along that.
/// - No view may see through the walls of the other (sight_check.h).
/// - In a wide window nothing else must fit nearly as well.
///
/// Deterministic, stateless.
class PlaceMatcher {
 public:
  explicit PlaceMatcher(const PlaceMatcherConfig& config = {});  ///< @throws std::invalid_argument

  /// @param place  what was seen around there, the view from the place itself last
  /// @param guess  `T_place_scan`
  /// @param window around the guess
  /// @return the match, its reference being the place; none where none is to be believed
  [[nodiscard]] std::optional<matching::MatchResult> match(
      const matching::Reference& place, const matching::View& scan, const geometry::Pose2& guess,
      const matching::SearchWindow& window) const;

 private:
  PlaceMatcherConfig config_;
  matching::PointToLineMatcher nearby_;  ///< in narrow windows
};

/// What is known of the places that a robot has been to.
struct KnownPlaces {
  const std::vector<KeyframePtr>& keyframes;
  const std::vector<geometry::Pose2>& poses;  ///< `T_map_base` of the first so many of them
};

/// A keyframe and its neighbours of the same stretch, in their order. Those without a pose are left
/// out.
/// @param reach neighbours on each side
[[nodiscard]] std::vector<graph::NodeId> neighboursOf(graph::NodeId center, graph::NodeId reach,
                                                      const KnownPlaces& known);

/// What these saw, in the frame of the keyframe; its own view is the last.
[[nodiscard]] matching::Reference placeAround(graph::NodeId center, graph::NodeId reach,
                                              const KnownPlaces& known);

}  // namespace omega_slam::slam

#pragma once

#include <optional>

#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/matching/point_to_line_matcher.h"
#include "omega_slam/slam/belief.h"
#include "omega_slam/slam/keyframe.h"

namespace omega_slam::slam {

/// Matches a keyframe with one of those just before, scan to scan, so that the graph holds a
/// network of constraints and not a chain (Lu and Milios 1997, "Globally consistent range scan
/// alignment for environment mapping", Autonomous Robots 4).
///
/// The tracked pose of a keyframe is one measurement. That the scans of neighbours fit each other
/// is another, with errors of its own: the map that scans are tracked on is rounded to cells, and
/// where the robot turns into the unknown it hardly knows more than the odometry does.
///
/// Deterministic, stateless.
class PairMatcher {
 public:
  /// @throws std::invalid_argument
  explicit PairMatcher(const matching::MatchConfig& config = {});

  /// @param tracked `T_from_to` as it was tracked, and how far that may be off, in the axes of
  /// `from`
  /// @return none where the two see too little of the same, or disagree with what was tracked
  [[nodiscard]] std::optional<graph::Constraint> match(const Keyframe& from, const Keyframe& to,
                                                       const Belief& tracked) const;

 private:
  matching::PointToLineMatcher matcher_;
};

}  // namespace omega_slam::slam

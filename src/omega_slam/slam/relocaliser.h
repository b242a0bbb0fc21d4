#pragma once

#include <optional>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/scan_matcher.h"
#include "omega_slam/slam/keyframe.h"
#include "omega_slam/slam/place_matcher.h"

namespace omega_slam::slam {

/// Where a lost robot has been found.
struct Relocation {
  graph::NodeId keyframe{0};
  matching::MatchResult match;  ///< `T_keyframe_base`
};

/// Finds a lost robot again, wherever in the graph it is: all places are tried, one with each scan,
/// so that a scan takes no longer than one wide search; those near where the robot was last
/// believed to be come first. One fit is not enough, since rooms look alike: nothing else within 6
/// m may fit nearly as well, and once the robot has moved on, by its odometry, what it sees then
/// must fit there too.
///
/// Not thread-safe.
class Relocaliser {
 public:
  explicit Relocaliser(const PlaceMatcherConfig& config);  ///< @throws std::invalid_argument

  /// @param scan from the base
  /// @param believed `T_map_base`, by the odometry since the robot was lost
  [[nodiscard]] std::optional<Relocation> look(const matching::View& scan,
                                               const geometry::Pose2& T_odom_base,
                                               const geometry::Pose2& believed,
                                               const KnownPlaces& known);

 private:
  struct Guess {
    geometry::Pose2 T_map_base;
    geometry::Pose2 T_odom_base;
  };

  [[nodiscard]] std::optional<Relocation> tryAt(graph::NodeId place, const matching::View& scan,
                                                const geometry::Pose2& guess,
                                                const matching::SearchWindow& window,
                                                const KnownPlaces& known) const;
  void listPlaces(const geometry::Pose2& believed, const KnownPlaces& known);

  PlaceMatcher matcher_;
  std::vector<graph::NodeId> places_;  ///< still to be tried in this round, the next last
  std::optional<Guess> guess_;         ///< to be confirmed
};

}  // namespace omega_slam::slam

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

/// Finds a lost robot again, wherever in the graph it is. One scan is laid on all places, a few
/// with each call, so that no scan takes long. One fit is not enough, since rooms look alike:
/// nothing else in the whole graph may fit nearly as well, and what the robot sees on the next
/// three metres, or while it turns on, must fit there too.
///
/// Not thread-safe.
class Relocaliser {
 public:
  explicit Relocaliser(const PlaceMatcherConfig& config);  ///< @throws std::invalid_argument

  /// @param scan from the base
  /// @param T_odom_base odometry at its stamp
  [[nodiscard]] std::optional<Relocation> look(const matching::View& scan,
                                               const geometry::Pose2& T_odom_base,
                                               const KnownPlaces& known);

  void rest();  ///< the robot is not lost any more

 private:
  /// The scan that is laid on all places.
  struct Round {
    matching::View scan;
    geometry::Pose2 T_odom_base;
  };
  struct Fit {
    geometry::Pose2 T_map_base;
    double confidence{0.0};
  };
  struct Guess {
    geometry::Pose2 T_map_base;
    geometry::Pose2 T_odom_base;
    int confirmations{0};  ///< looks since that have fitted, less those that have not
  };

  [[nodiscard]] std::optional<Relocation> confirm(const matching::View& scan,
                                                  const geometry::Pose2& T_odom_base,
                                                  const KnownPlaces& known);
  void guessFromRound();
  [[nodiscard]] std::optional<Relocation> tryAt(graph::NodeId place, const matching::View& scan,
                                                const geometry::Pose2& guess,
                                                const matching::SearchWindow& window,
                                                const KnownPlaces& known) const;

  PlaceMatcher matcher_;
  Round round_;
  std::vector<graph::NodeId> places_;  ///< still to be tried in this round
  std::vector<Fit> fits_;              ///< of this round, at the places tried
  std::optional<Guess> guess_;         ///< to be confirmed
};

}  // namespace omega_slam::slam

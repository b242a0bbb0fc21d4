#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/local_map.h"
#include "omega_slam/matching/map_matcher.h"
#include "omega_slam/matching/matcher_factory.h"
#include "omega_slam/slam/belief.h"
#include "omega_slam/slam/place_matcher.h"

namespace omega_slam::slam {

/// What the odometry says of the motion from one scan to the next.
struct OdometryStep {
  geometry::Pose2 motion;                               ///< `T_before_after` of the base
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};  ///< in the axes of `before`
  double seconds{0.0};                                  ///< that it has taken
  bool has_jumped{false};  ///< no motion is like that: next to none is known
};

/// Where a scan was taken, by the odometry and by what it saw.
struct TrackedScan {
  Belief predicted;             ///< `T_map_base` by the odometry alone
  Belief matched;               ///< by what was seen alone; only of a match that is trusted
  Belief belief;                ///< by both
  matching::MatchResult match;  ///< reference: the map
  bool is_trusted{false};       ///< whether the match had a say
  bool has_slipped{false};      ///< the match says that the odometry of this step was wrong
  bool is_contradicted{false};  ///< much of it lies where the map knows that nothing is
};

/// Follows the robot from scan to scan: predicts by the odometry, matches with a map, and fuses the
/// two by their covariances, as a Kalman filter does (Thrun, Burgard, Fox 2005, table 3.1).
///
/// Neither is believed blindly. Where the two are too far apart for chance, the scan itself
/// decides: if it fits the map clearly better where it was matched, the wheels have slipped, and
/// their step says little beside what the match is sure of; else the match may as well have been
/// drawn astray, as it is in front of a bare wall, and counts for as little as makes the two agree.
///
/// A scan that fits nowhere near is not trusted at all: see recover(). If the map knows that
/// nothing is where much of the scan lies, the robot is not where it is believed to be.
class ScanTracker {
 public:
  /// @param min_confidence of a match with the map
  /// @param places what is asked of a scan that is looked for all around
  ScanTracker(const matching::MatcherConfig& matching, double min_confidence,
              const PlaceMatcherConfig& places = {});

  /// @param reference what the scan is matched with
  /// @param before where the scan before was taken, `T_map_base`
  [[nodiscard]] TrackedScan track(const matching::LocalMap& map, const matching::View& scan,
                                  const Belief& before, const OdometryStep& step) const;

  /// Looks for a scan that is not trusted all around where it is believed to have been taken:
  /// odometry can jump, and robots are lifted and turned. Costs as much as a wide search.
  /// @return the scan where it was found; else as it was tracked
  [[nodiscard]] TrackedScan recover(const matching::LocalMap& map, const matching::View& scan,
                                    const TrackedScan& tracked) const;

 private:
  [[nodiscard]] matching::MatchResult match(const matching::LocalMap& map,
                                            const matching::View& scan,
                                            const geometry::Pose2& guess) const;
  [[nodiscard]] bool isContradicted(const matching::LocalMap& map, const matching::View& scan,
                                    const matching::MatchResult& match) const;
  [[nodiscard]] bool fitsBetter(const matching::LocalMap& map, const matching::View& scan,
                                const matching::MatchResult& match,
                                const geometry::Pose2& elsewhere) const;

  double min_confidence_;
  matching::MatchConfig match_config_;
  PlaceMatcher places_;
  std::unique_ptr<const matching::ScanMatcher> matcher_;
  const matching::MapMatcher* map_matcher_;  ///< matcher_, if it knows how to use a map
};

}  // namespace omega_slam::slam

#pragma once

#include <string>
#include <vector>

#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

struct HillClimbingConfig {
  double direction_step{0.3};  ///< [rad] first step of the direction of movement
  double distance_step{0.15};  ///< [m] first step of the distance moved
  double rotation_step{0.1};   ///< [rad] first step of the rotation
  double distance_reach{2.0};  ///< [m] to each side, when the distance is taken up first
  double rotation_reach{1.5};  ///< [rad] likewise; less than a quarter turn, since rooms are square
  double shrink{0.85};         ///< of the steps, whenever another variable is taken up
  int rounds{20};              ///< each takes up each variable once
  double error_cap{0.3};       ///< [m] of a ray's error, see RayReference

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Hill climbing as in the paper (section 6.4): minimises the squared error of the rays over the
/// direction of movement, the distance and the rotation of the scan, one variable at a time, with
/// steps that shrink whenever another is taken up. docs/algorithms/matching/hill_climbing.md tells
/// where this goes beyond the paper.
///
/// Converged means that in the end no variable had a better value one smallest step away.
class HillClimbingMatcher : public ScanMatcher {
 public:
  /// @throws std::invalid_argument
  explicit HillClimbingMatcher(const HillClimbingConfig& config = {},
                               const MatchConfig& common = {});
  [[nodiscard]] MatchResult match(const Reference& reference, const View& scan,
                                  const geometry::Pose2& guess) const override;

 private:
  HillClimbingConfig config_;
  MatchConfig common_;
};

}  // namespace omega_slam::matching

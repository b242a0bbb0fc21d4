#pragma once

#include <string>
#include <vector>

#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

struct PointToLineMatcherConfig {
  int max_iterations{50};                   ///< steps at most; 0 only judges the guess
  double max_correspondence_distance{0.5};  ///< [m] first step: how far off the guess may be

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// ICP with the point-to-line metric (Censi 2008, "An ICP variant using a point-to-line metric",
/// ICRA), by Gauss-Newton steps.
///
/// At first partners may lie as far away as the guess may be off. With each step that reach
/// shrinks, down to the common outlier distance, and with it the distance at which a partner counts
/// half. A hundred points of the scan show the way; the last steps take all, unless the few fit so
/// badly that the caller would have no use for the match. Directions that the points do not
/// determine stay at the guess.
///
/// Deviations from the paper: neighbours are found in a grid instead of by the sweep's order, so
/// that the reference may be any number of views; a line is fitted to the points within 0.3 m
/// instead of drawn through two; points that lie on no line count by their distance; outliers are
/// weighed down instead of trimmed; a step is linear instead of the closed solution.
///
/// O(iterations * points). Covariance, confidence and failures are judgeMatch's; without
/// convergence the failure is kNotConverged, unless there is a worse one.
class PointToLineMatcher : public ScanMatcher {
 public:
  /// @param least_confidence [0, 1] below which the caller has no use for a match: what will
  /// clearly not come to it is given up early, which is a refusal for kNotConverged
  /// @throws std::invalid_argument
  explicit PointToLineMatcher(const PointToLineMatcherConfig& config = {},
                              const MatchConfig& common = {}, double least_confidence = 0.0);
  [[nodiscard]] MatchResult match(const Reference& reference, const View& scan,
                                  const geometry::Pose2& guess) const override;

 private:
  PointToLineMatcherConfig config_;
  MatchConfig common_;
  double least_confidence_;
};

}  // namespace omega_slam::matching

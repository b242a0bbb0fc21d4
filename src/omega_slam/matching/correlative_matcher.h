#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "omega_slam/matching/correlative_search.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

struct CorrelativeMatcherConfig {
  SearchWindow window{0.3, 0.35};  ///< around the guess: what it may be off by
  double resolution{0.02};         ///< [m] of the search; the refinement goes below it
  int max_refinements{20};         ///< steps of the refinement
  /// [0, 1] Of a peak; where none reaches it, there is no match. More makes hopeless searches
  /// short.
  double least_score{0.0};
  double least_rival{0.0};  ///< [0, 1] likewise of further peaks, of the best one's score

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// A match, and what else it could have been.
struct CorrelativeMatch {
  MatchResult result;
  std::vector<CorrelativePeak> peaks;  ///< best first; `result` refines the first of them

  /// Score of the second peak over that of the first: near 1 where two places look alike, 0 where
  /// there is no second one.
  [[nodiscard]] double ambiguity() const;
};

/// Finds the best pose in a window around the guess, wherever in it the guess may lie, by a
/// CorrelativeSearch, and carries it to millimetres by a
/// FieldRefinement.
///
/// Surfaces are what neighbouring beams trace out together (traceSurfaces), so that a scan is not
/// tied to the spacing of the beams, and they are matched only with what faces the same way.
/// Confidence, overlap and residual are those of match_quality.h; so is the covariance, but wider
/// wherever the correlation volume is (widenByVolume). Along a direction that stays open the pose
/// goes back to the guess: in a corridor nothing else knows better.
///
/// Returns beyond 100 m are left out. Reference of n returns, scan of m: O((n + m) * window^3) at
/// worst, as trying every pose, and in practice nearly independent of the window; memory O(n).
class CorrelativeMatcher : public ScanMatcher {
 public:
  /// @throws std::invalid_argument
  explicit CorrelativeMatcher(const CorrelativeMatcherConfig& config = {},
                              const MatchConfig& common = {});

  [[nodiscard]] MatchResult match(const Reference& reference, const View& scan,
                                  const geometry::Pose2& guess) const override;

  /// The same, with up to `count` peaks at least 0.5 m or 0.35 rad apart. More than one may cost
  /// several times as much.
  [[nodiscard]] CorrelativeMatch matchWithPeaks(const Reference& reference, const View& scan,
                                                const geometry::Pose2& guess,
                                                std::size_t count) const;

 private:
  CorrelativeMatcherConfig config_;
  MatchConfig common_;
};

}  // namespace omega_slam::matching

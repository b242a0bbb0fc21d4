#pragma once

#include <memory>
#include <string>
#include <vector>

#include "omega_slam/matching/local_map.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

struct MapMatcherConfig {
  LocalMapConfig map;
  int max_iterations{20};      ///< on each grid; 0: the guess is judged as it is
  double min_confidence{0.6};  ///< below it the scan counts as lost, and the fallback searches

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Scan to map (Kohlbrecher et al. 2011, section IV): a scan is laid on a LocalMap by Gauss-Newton,
/// see alignToMap, and judged by it, see gatherEvidence.
///
/// Accurate and fast, but it sees no farther than a cell of the coarsest grid or two. So the result
/// is judged, and if that says that the scan is lost, a matcher that searches wide finds a place to
/// begin again from.
class MapMatcher : public ScanMatcher {
 public:
  /// @param fallback asked where the scan is lost; may be none
  /// @throws std::invalid_argument
  explicit MapMatcher(const MapMatcherConfig& config = {}, const MatchConfig& common = {},
                      std::unique_ptr<const ScanMatcher> fallback = nullptr);

  /// Builds a map of the reference and matches with that.
  [[nodiscard]] MatchResult match(const Reference& reference, const View& scan,
                                  const geometry::Pose2& guess) const override;

  /// Matches with a map that the caller keeps: for tracking, where each scan is matched and some
  /// are put in.
  /// @param guess `T_map_scan` to begin with
  /// @return the result's reference is the map
  [[nodiscard]] MatchResult track(const LocalMap& map, const View& scan,
                                  const geometry::Pose2& guess) const;

 private:
  [[nodiscard]] MatchResult alignAndJudge(const LocalMap& map, const View& scan,
                                          const geometry::Pose2& guess) const;

  MapMatcherConfig config_;
  MatchConfig common_;
  std::unique_ptr<const ScanMatcher> fallback_;
};

}  // namespace omega_slam::matching

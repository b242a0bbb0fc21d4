#pragma once

#include <cstddef>

#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// Whether two views could be of one place: what one of them has seen through.
struct SightCheck {
  std::size_t compared{0};      ///< points that the other's beams pass or meet
  std::size_t seen_through{0};  ///< of them, those that the beams pass

  /// [0, 1]; 0 where nothing could be compared
  [[nodiscard]] double contradiction() const {
    return compared == 0 ? 0.0 : static_cast<double>(seen_through) / static_cast<double>(compared);
  }
};

/// Looks at the points of `seen` along the beams of `eye`: a point well in front of what the beams
/// around it have hit has been seen through, so it was not there. Points behind what was hit are
/// hidden and say nothing. Both views in one frame; O(n).
///
/// The thought is that of the ray test of Nieto et al. 2007 ("Recursive scan-matching SLAM",
/// RAS 55) and of Gutmann and Konolige 1999: overlap alone lets two rooms of one shape pass.
[[nodiscard]] SightCheck checkSight(const View& eye, const View& seen);

/// Both ways, added up.
[[nodiscard]] SightCheck checkSightBothWays(const View& a, const View& b);

}  // namespace omega_slam::matching

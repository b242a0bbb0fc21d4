#pragma once

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// Where to look around a guess.
struct SearchWindow {
  double translation{1.0};  ///< [m] to each side along x and y
  double rotation{0.3};     ///< [rad] to each side
};

/// The pose in a window around a guess at which most points of the scan fall on points of the
/// reference: a correlative search (Olson 2009, "Real-time correlative scan matching") on one
/// coarse grid, every pose tried. Good to about a grid cell, 0.1 m, wherever in the window the
/// truth lies: a beginning for a matcher that only looks nearby. Among equals the pose nearest to
/// the guess wins, so that a corridor does not lead astray.
///
/// O(poses in the window * points), of which it takes at most a hundred, evenly chosen.
/// Deterministic.
/// @return `T_reference_scan`; the guess where nothing overlaps or one of the two is empty
[[nodiscard]] geometry::Pose2 searchCoarsely(const Points& reference, const Points& scan,
                                             const geometry::Pose2& guess,
                                             const SearchWindow& window);

}  // namespace omega_slam::matching

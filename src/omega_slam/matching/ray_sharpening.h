#pragma once

#include <optional>

#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// Looks along the direction that a match knows least, for what points on walls can't tell but rays
/// can: how far doors, corners and ends of walls are shifted.
///
/// Points tie a scan to the lines that they lie on, and noise tilts lines: in a corridor nearly all
/// that they seem to say of its direction may be pretence, and is not believed (Surface). The rays'
/// squared error (RayReference) does not need lines. Where it rises to both sides, 0.25 m or rad
/// away, by more than the noise of the ranges, the direction is determined after all. The pose
/// moves to the least error along it, and the covariance shrinks by what a parabola through that
/// rise says, were there no more than 30 rays that err independently.
///
/// @param found a match that points have led to
/// @return what it becomes; none where it is in no doubt, or rays tell no more
[[nodiscard]] std::optional<MatchResult> sharpenByRays(const Reference& reference, const View& scan,
                                                       const MatchResult& found,
                                                       const MatchConfig& config);

}  // namespace omega_slam::matching

#pragma once

#include <optional>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// Looks along the direction that a match knows least, for what points on walls can't tell but rays
/// can: how far doors, corners and ends of walls are shifted.
///
/// Points tie a scan to the lines that they lie on, and noise tilts lines: in a corridor nearly all
/// that they seem to say of its direction may be pretence, and is not believed (Surface). The rays'
/// squared error (RayReference) does not need lines. Where it has a valley that rises to both
/// sides, 0.25 m or rad away, by more than the error at its bottom and the noise of the ranges, the
/// pose belongs there.
///
/// That is a better pose, but no more certain than the points have it: doors look alike. In
/// simulated offices, loops that were given the certainty of such valleys too made trajectories
/// worse.
///
/// @param found a match that points have led to
/// @return `T_reference_scan`; none where `found` is in no doubt, or rays tell no more
[[nodiscard]] std::optional<geometry::Pose2> sharpenByRays(const Reference& reference,
                                                           const View& scan,
                                                           const MatchResult& found,
                                                           const MatchConfig& config);

}  // namespace omega_slam::matching

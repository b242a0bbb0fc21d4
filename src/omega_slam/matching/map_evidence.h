#pragma once

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/local_map.h"
#include "omega_slam/matching/match_quality.h"

namespace omega_slam::matching {

/// What a scan laid on a map says of its pose, in the terms of judgeMatch: the partner of a point
/// is the occupied cell nearest to it, and the surface there the line through the occupied cells
/// around the point, each as heavy as it is likely.
///
/// Looks at the finest grid of which two cells are as wide as `reach`; O(points).
/// @param scan, T_map_scan finite
/// @param reach [m] farther partners are none
[[nodiscard]] MatchEvidence gatherEvidence(const LocalMap& map, const Points& scan,
                                           const geometry::Pose2& T_map_scan, double reach);

/// How well a scan fits a map where it is said to have been taken: a match without a search.
[[nodiscard]] MatchResult judgeOnMap(const LocalMap& map, const Points& scan,
                                     const geometry::Pose2& T_map_scan, const MatchConfig& config);

/// Share of a scan's points that lie well within what the map knows to be free. Where the map knows
/// nothing it contradicts nothing.
/// @param T_map_scan finite
[[nodiscard]] double contradictionOf(const LocalMap& map, const Points& scan,
                                     const geometry::Pose2& T_map_scan);

}  // namespace omega_slam::matching

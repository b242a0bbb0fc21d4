#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "omega_slam/matching/scan_matcher.h"
#include "omega_slam/matching/surface_model.h"

namespace omega_slam::matching {

/// The piece of a surface around a return. Its normal points to the side that was seen.
struct SurfacePatch {
  Eigen::Vector2d hit{0.0, 0.0};    ///< [m] the return
  Eigen::Vector2d point{0.0, 0.0};  ///< [m] the same on the line, where there is one
  Surface surface;
  bool joins_next{false};  ///< the next return is of the same surface
};

/// The patches around the returns of a view, in their order. Returns of neighbouring beams are of
/// one surface unless their gap is too long for their distance from the laser, as it is where an
/// edge hides what lies behind; a line is fitted to those around each. Linear, thanks to the
/// sweep's order.
/// @param view within a few hundred metres of its frame's origin
[[nodiscard]] std::vector<SurfacePatch> tracePatches(const View& view);

/// A place on a surface, and the patch that it belongs to.
struct SurfaceSample {
  Eigen::Vector2d place{0.0, 0.0};  ///< [m]
  std::size_t patch{0};             ///< index of TracedSurfaces::patches
};

/// Surfaces as sweeps have traced them: walls, and not only the places where beams met them.
struct TracedSurfaces {
  std::vector<SurfacePatch> patches;
  std::vector<SurfaceSample> samples;
};

/// Samples the surfaces of all views, where these overlap that of the newest.
/// @param spacing [m] between samples, > 0: no wider along a surface, and hardly any closer
[[nodiscard]] TracedSurfaces traceSurfaces(const Reference& reference, double spacing);

/// Of the points that fall into one square of a grid, the first.
/// @param spacing [m] side of a square, > 0
[[nodiscard]] Points thinned(const Points& points, double spacing);

}  // namespace omega_slam::matching

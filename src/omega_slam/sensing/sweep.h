#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::sensing {

/// What one beam says (REP-117).
enum class BeamKind : std::uint8_t {
  kUnknown = 0,  ///< NaN, too close, or invalid: says nothing
  kReturn = 1,   ///< hit something at `end`
  kNoReturn = 2  ///< nothing within range: free up to `end`, no obstacle there
};

struct Beam {
  Eigen::Vector2d end{
      0.0, 0.0};  ///< [m] in the robot's base frame at the sweep's stamp; meaningless if unknown
  BeamKind kind{BeamKind::kUnknown};
};

/// One laser sweep in the robot's base frame, free of the motion during it: every beam's end is
/// where it lies seen from the base at `stamp`, the middle of the sweep. What the motion is wrong
/// by then turns its first half one way and its second half the other, and a match of the whole is
/// nearly right; seen from the first beam, it would turn all of it by half of the error.
/// Beams stand in the order of the sweep,
/// counter-clockwise seen from above, so that neighbours in the list are neighbours in space.
struct Sweep {
  double stamp{0.0};             ///< [s] the middle of the sweep
  geometry::Pose2 T_base_laser;  ///< the laser at the stamp; beams start at its origin
  double angle_increment{0.0};   ///< [rad] between neighbouring beams, > 0
  std::vector<Beam> beams;

  /// Ends of the beams that hit something [m], base frame, in sweep order.
  [[nodiscard]] std::vector<Eigen::Vector2d> returns() const;
};

}  // namespace omega_slam::sensing

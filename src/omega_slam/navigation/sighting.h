#pragma once

#include <Eigen/Core>
#include <vector>

#include "omega_slam/sensing/sweep.h"

namespace omega_slam::navigation {

/// What a laser saw at one moment. All points [m] in one frame.
struct Sighting {
  double stamp{0.0};                     ///< [s]
  Eigen::Vector2d origin{0.0, 0.0};      ///< where the beams start
  std::vector<Eigen::Vector2d> returns;  ///< where beams ended on something
  std::vector<Eigen::Vector2d> clear;    ///< how far beams without a return are known to be free
};

/// A sweep as a sighting in the base frame at its stamp.
[[nodiscard]] Sighting sightingFrom(const sensing::Sweep& sweep);

}  // namespace omega_slam::navigation

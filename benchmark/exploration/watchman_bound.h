#pragma once

#include <vector>

#include "omega_slam/simulation/world.h"

namespace omega_slam::experiments {

/// How short a way can be, at the very least, on which a robot sees all of a world.
struct WatchmanBound {
  double length{0.0};                      ///< [m] of a closed way, wherever it begins
  std::vector<Eigen::Vector2d> witnesses;  ///< [m] places that must be seen
};

/// A lower bound for the watchman's route (Chin and Ntafos, "Optimum Watchman Routes", 1988) of a
/// round robot whose sight has a range.
///
/// To see a place, the robot must come into the region from which it is in sight. So whoever sees
/// some places, the witnesses, comes to all of their regions, and a tour between regions with the
/// least distances between each two of them is not longer than that way; tourBound() bounds the
/// tour. Witnesses are chosen from places that are seen from few others, so that the bound becomes
/// great; any choice gives one.
///
/// Regions and room are taken a little too large, and distances over cells in eight directions are
/// divided by the most that these can be too long (1.0824), so that the bound holds.
/// @param start [m] from which it gets to where the way may lead; @param radius [m] of the robot
/// @param sight [m] how far it sees
[[nodiscard]] WatchmanBound watchmanBound(const simulation::World& world,
                                          const Eigen::Vector2d& start, double radius,
                                          double sight);

}  // namespace omega_slam::experiments

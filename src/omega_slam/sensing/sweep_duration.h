#pragma once

#include "omega_slam/sensing/laser_scan.h"

namespace omega_slam::sensing {

/// No 2D laser takes longer for one sweep [s]; a time_increment that says so is wrong.
inline constexpr double kLongestSweep = 2.0;

/// From the first beam to the last [s]; 0 where the scan's time_increment makes no sense (negative,
/// not finite, or a sweep longer than kLongestSweep), as ScanIntake reads it.
[[nodiscard]] double sweepDuration(const LaserScan& scan);

/// The time [s] halfway between the first beam and the last: that of a Sweep.
[[nodiscard]] double middleOfSweep(const LaserScan& scan);

}  // namespace omega_slam::sensing

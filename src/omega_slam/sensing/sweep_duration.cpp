#include "omega_slam/sensing/sweep_duration.h"

namespace omega_slam::sensing {

double sweepDuration(const LaserScan& scan) {
  if (scan.ranges.empty()) {
    return 0.0;
  }
  const double duration = scan.time_increment * static_cast<double>(scan.ranges.size() - 1);
  return duration >= 0.0 && duration <= kLongestSweep ? duration : 0.0;
}

double middleOfSweep(const LaserScan& scan) { return scan.stamp + 0.5 * sweepDuration(scan); }

}  // namespace omega_slam::sensing

#pragma once

#include <sensor_msgs/LaserScan.h>

#include <deque>
#include <optional>
#include <vector>

#include "omega_slam/sensing/laser_scan.h"

namespace omega_slam {

/// A scan that waits for the odometry of its time.
struct WaitingScan {
  sensor_msgs::LaserScan::ConstPtr message;
  sensing::LaserScan scan;
  double end{0.0};      ///< [s] stamp of the last beam
  double arrival{0.0};  ///< [s] on a clock that never jumps
};

/// Scans by their stamps, oldest first; bounded. A scan is given up only when it has waited its
/// patience out by the messages' time and by the wall's as well: by the messages' alone, a
/// simulation faster than real time would lose all its scans; by the wall's alone, one that is
/// paused would. Still, nothing waits by the wall's time for more than twenty times its patience: a
/// scan from the far future must not stay for ever. Not thread-safe.
class ScanQueue {
 public:
  /// @param patience [s]
  ScanQueue(double patience, std::size_t capacity);

  /// @return the oldest scan, where there was no room for one more
  std::optional<WaitingScan> push(WaitingScan scan);
  [[nodiscard]] bool empty() const { return scans_.empty(); }
  [[nodiscard]] const WaitingScan& front() const { return scans_.front(); }  ///< not when empty
  WaitingScan pop();                                                         ///< not when empty
  void clear() { scans_.clear(); }

  /// @param newest_odometry [s] newest stamp of the odometry, if there is any
  /// @param now             [s] on the clock of `arrival`
  /// @return the scans given up; they are no longer in the queue
  [[nodiscard]] std::vector<WaitingScan> giveUp(std::optional<double> newest_odometry, double now);

 private:
  double patience_;
  std::size_t capacity_;
  std::deque<WaitingScan> scans_;
};

}  // namespace omega_slam

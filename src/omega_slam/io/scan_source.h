#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/laser_scan.h"

namespace omega_slam::io {

/// A scan with all that is needed to use it.
struct ScanRecord {
  sensing::LaserScan scan;
  sensing::LaserMount mount;
  geometry::Pose2 T_odom_base;          ///< odometry at the scan's stamp
  geometry::Pose2 motion_during_sweep;  ///< `T_start_end` of the base, first beam to last
};

/// A recorded run, whatever its format. Not thread-safe.
class ScanSource {
 public:
  virtual ~ScanSource() = default;

  /// The next scan, in the order of the recording; none at the end.
  /// @throws std::runtime_error with one sentence if the recording is damaged from here on
  [[nodiscard]] virtual std::optional<ScanRecord> next() = 0;

  /// Share of the recording that has been read, in [0, 1].
  [[nodiscard]] virtual double progress() const = 0;

  /// Scans that could not be handed out so far, by cause: short stable phrases.
  [[nodiscard]] virtual std::map<std::string, std::size_t> dropped() const = 0;

  /// What was found, in one sentence for the user.
  [[nodiscard]] virtual std::string description() const = 0;
};

}  // namespace omega_slam::io

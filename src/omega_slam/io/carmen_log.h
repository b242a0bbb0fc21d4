#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/laser_scan.h"

namespace omega_slam::io {

struct CarmenLogOptions {
  /// [m] A range of this or more is the scanner's way to say "no return" and becomes +inf. Logs
  /// mark it by 50, 80, 81.83, 81.91, ...; indoor lasers of the time do not see farther than this.
  double no_return_range{49.9};

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// One scan of a log with the odometry that was logged with it.
struct CarmenRecord {
  /// `stamp` is the message's IPC time stamp [s], all beams taken at once; `range_max` is the
  /// no-return limit.
  sensing::LaserScan scan;
  geometry::Pose2 T_odom_base;
};

struct CarmenLog {
  std::vector<CarmenRecord> records;  ///< in the order of the file, whatever their stamps
  std::size_t backward_stamps{0};     ///< records with a stamp before that of their predecessor
  std::size_t malformed_lines{0};     ///< laser messages that could not be used
  std::string first_fault;            ///< "line 17: why" of the first such line
};

/// Reads a CARMEN log in text form.
///
/// Laser messages read are FLASER (the front laser) and, in a log that has none, ROBOTLASER1, its
/// successor; other messages are passed over. FLASER says nothing of its beams' angles: by the
/// habit of the SICK lasers of these logs they span 180 degrees from -90 degrees on, an odd number
/// with beams at both ends (181: every degree), an even number without the last (180: every
/// degree). The odometry is the second pose of FLASER; the first is the laser's corrected pose,
/// which in raw logs is the same. A range of no_return_range or more becomes +inf, one of 0 or less
/// and one that is no number NaN (REP-117). Numbers that are malformed in any other place make the
/// line malformed: it is counted and passed over.
///
/// @throws std::runtime_error with one sentence if the file can't be read or has no usable laser
/// message at all; std::invalid_argument for options that are not valid
[[nodiscard]] CarmenLog readCarmenLog(const std::filesystem::path& path,
                                      const CarmenLogOptions& options = {});

/// The same from text. @param name how messages call it
[[nodiscard]] CarmenLog parseCarmenLog(std::string_view text, const std::string& name,
                                       const CarmenLogOptions& options = {});

}  // namespace omega_slam::io

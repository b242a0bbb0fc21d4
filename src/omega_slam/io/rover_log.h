#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/io/scan_source.h"

namespace omega_slam::io {

/// The rover that the logs are of: a differential drive with encoders and a Hokuyo URG-04LX.
struct RoverGeometry {
  double wheel_radius{0.077};                     ///< [m]
  double half_axle{0.165};                        ///< [m] from the middle to a wheel
  double ticks_per_turn{2000.0};                  ///< of an encoder
  geometry::Pose2 T_base_laser{0.145, 0.0, 0.0};  ///< the base is the middle of the axle
};

struct RoverLog {
  std::vector<ScanRecord> records;  ///< in the order of the file
  std::size_t malformed_lines{0};   ///< passed over
  std::string first_fault;          ///< "line 17: why" of the first such line
};

/// Reads a log of the Mines ParisTech rover, as it came with tinySLAM (Steux and El Hamzaoui,
/// "tinySLAM: a SLAM algorithm in less than 200 lines of C language", ICARCV 2010).
///
/// A line is one scan: the time [us], a number, the ticks of the left and of the right encoder, 21
/// numbers that are not used here, and 682 ranges [mm] from -120 degrees on, 360/1024 degrees
/// apart, counter-clockwise. A range of 0 means that nothing returned and becomes +inf; below 20 mm
/// it is a code of the laser's for an error, and becomes NaN. Nothing says when in its turn the
/// mirror was at that time: all beams are taken at once.
///
/// The odometry begins at zero. From line to line both wheels are taken to turn steadily.
///
/// @throws std::runtime_error with one sentence if the file can't be read or has no usable line
[[nodiscard]] RoverLog readRoverLog(const std::filesystem::path& path,
                                    const RoverGeometry& rover = {});

/// The same from text. @param name how messages call it
[[nodiscard]] RoverLog parseRoverLog(std::string_view text, const std::string& name,
                                     const RoverGeometry& rover = {});

}  // namespace omega_slam::io

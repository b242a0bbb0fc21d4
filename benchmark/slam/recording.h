#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/relation.h"
#include "omega_slam/io/scan_source.h"
#include "omega_slam/simulation/hokuyo.h"
#include "omega_slam/simulation/world_file.h"

namespace omega_slam::experiments {

/// A run to be played, and what is known of the truth.
struct Recording {
  std::string name;
  std::vector<io::ScanRecord> records;
  geometry::Trajectory truth;              ///< `T_world_base` of a simulated drive; else empty
  std::vector<graph::Relation> relations;  ///< of a log, where there are any
  geometry::Trajectory odometry;           ///< dense, by which the relations' stamps are met
};

/// Files of a log. All but the first may be missing: empty. Of the relations those are kept that
/// lie within the log's time.
struct LogFiles {
  std::filesystem::path log;
  std::filesystem::path relations;
  std::filesystem::path odometry;
};

/// @throws std::runtime_error with one sentence if a file can't be read
[[nodiscard]] Recording readRecording(const std::string& name, const LogFiles& files);

/// Names of the lasers that a TurtleBot may carry here:
///   urg      683 beams, 240 degrees,  4 m, 10 Hz: the TurtleBot's own
///   sick     181 beams, 180 degrees,  8 m, 10 Hz
///   rplidar  360 beams, 360 degrees, 12 m,  5 Hz
///   utm     1081 beams, 270 degrees, 30 m, 40 Hz
[[nodiscard]] std::vector<std::string> laserNames();

/// By their makers' data sheets. @throws std::invalid_argument for another name
[[nodiscard]] simulation::HokuyoConfig laserNamed(const std::string& name);

struct DriveSettings {
  std::string laser{"urg"};
  double noise{1.0};      ///< of the odometry, times the default's deviations
  double seconds{900.0};  ///< the drive is cut off then
};

/// A drive along a world's route. The same seed gives the same route and the same errors, which the
/// noise only scales.
[[nodiscard]] Recording simulateRecording(const simulation::LoadedWorld& world,
                                          const DriveSettings& settings, std::uint64_t seed);

}  // namespace omega_slam::experiments

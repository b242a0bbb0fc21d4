#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <vector>

#include "experiments/determination.h"
#include "experiments/places.h"

namespace omega_slam::experiments {

/// Pairs of consecutive key scans, 0.5 m or 0.5 rad apart.
struct KeyPairs {
  std::vector<ScanPair> pairs;
  RangeDeviation deviation;  ///< of the laser, for what the scans determine
};

/// A robot strolls through the arena: half a metre ahead where there is room, else, and now and
/// then, half a radian to a side. Scans are taken at rest; truth is exact.
[[nodiscard]] KeyPairs strollPairs(const Arena& arena, std::size_t count, std::uint32_t seed);

/// Key scans of a recorded CARMEN log; truth is the trajectory that slam::Pipeline solves with its
/// defaults.
/// @param most_scans of the log are read
/// @throws std::runtime_error if the log can't be read
[[nodiscard]] KeyPairs recordedPairs(
    const std::filesystem::path& log,
    std::size_t most_scans = std::numeric_limits<std::size_t>::max());

/// All scans of a drive, and the odometry.
struct Drive {
  std::vector<matching::View> views;
  std::vector<geometry::Pose2> T_odom_base;  ///< as many
};

/// The stroll of strollPairs, with a scan every 5 cm or 0.05 rad, and odometry that overstates ways
/// by 3 % and turns by 5 %.
[[nodiscard]] Drive strollDrive(const Arena& arena, std::size_t most_scans, std::uint32_t seed);

/// @param most_scans of the log are read
/// @throws std::runtime_error if the log can't be read
[[nodiscard]] Drive recordedDrive(const std::filesystem::path& log, std::size_t most_scans);

}  // namespace omega_slam::experiments

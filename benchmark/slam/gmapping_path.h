#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/io/scan_source.h"

namespace omega_slam::experiments {

/// Where gmapping has put some of a log's scans.
struct CorrectedScans {
  std::vector<std::size_t> scans;      ///< their numbers in the log
  std::vector<geometry::Pose2> poses;  ///< gmapping's `T_map_base`, as many
};

/// Reads a log that gmapping has corrected. Its stamps are cut short, so its scans are found in the
/// log that they come from by their ranges, which are the same; those that are not found are left
/// out.
/// @throws std::runtime_error if it can't be read
[[nodiscard]] CorrectedScans readCorrectedScans(const std::filesystem::path& path,
                                                const std::vector<io::ScanRecord>& log);

}  // namespace omega_slam::experiments

#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/io/scan_source.h"

namespace omega_slam::io {

/// Opens a log by the ending of its name: `.dat` is the Mines ParisTech rover's (rover_log.h),
/// anything else CARMEN's (carmen_log.h).
/// @param T_base_laser where the laser sits; by default where the rover has it, or at the base
/// @throws std::runtime_error with one sentence that names the file and what is wrong
[[nodiscard]] std::unique_ptr<ScanSource> openLog(
    const std::filesystem::path& path,
    const std::optional<geometry::Pose2>& T_base_laser = std::nullopt);

}  // namespace omega_slam::io

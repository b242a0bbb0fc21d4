#pragma once

#include <filesystem>
#include <string>

#include "omega_slam/slam/pipeline.h"
#include "slam/recording.h"

namespace omega_slam::experiments {

/// The walls that a log's scans make at our poses, and at gmapping's: a row of a table for each who
/// has poses, and a picture, `<name>_<who>.png`. All draw the same scans, those that gmapping has
/// kept; without it, all scans.
/// @param corrected gmapping's log; may be empty
/// @param folder for the pictures
/// @return the table, with its head
/// @throws std::runtime_error if a file can't be read or written
[[nodiscard]] std::string compareWalls(const Recording& recording,
                                       const slam::PipelineConfig& config,
                                       const std::filesystem::path& corrected,
                                       const std::filesystem::path& folder);

}  // namespace omega_slam::experiments

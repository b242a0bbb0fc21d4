#pragma once

#include <cstddef>
#include <string>

#include "omega_slam/slam/pipeline.h"
#include "slam/log_faults.h"

namespace omega_slam::experiments {

/// A log driven over and over: to its end, back again in reverse, once more to its end, and so on.
/// So the robot is nowhere lifted from the end to the start; odometry and time run on.
[[nodiscard]] Records drivenOver(const Records& log, int passes);

/// What scans cost as the work grows: a row of a table for so many scans, with the time that they
/// took, the size of the graph after them and the memory that the process then holds.
[[nodiscard]] std::string growthTable(const std::string& name, const Records& log, int passes,
                                      const slam::PipelineConfig& config,
                                      std::size_t scans_a_row = 500);

}  // namespace omega_slam::experiments

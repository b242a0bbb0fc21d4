#pragma once

#include <string>

#include "omega_slam/slam/pipeline.h"
#include "slam/recording.h"

namespace omega_slam::experiments {

/// Processor time of the whole of SLAM, a scan, in units of one match by PCL's ICP between two
/// keyframes that follow each other, begun from the odometry: a ratio that holds on any machine.
/// @return the head of a table and one row
[[nodiscard]] std::string icpRatioTable(const Recording& recording,
                                        const slam::PipelineConfig& config);

}  // namespace omega_slam::experiments

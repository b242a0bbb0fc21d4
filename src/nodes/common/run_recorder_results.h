#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "nodes/common/run_recorder_record.h"
#include "omega_slam/evaluation/report.h"

namespace omega_slam {

/// Writes what came of a run into a folder, each file atomically: map.pgm, map.yaml and map.png
/// where there is a map, trajectory.tum, graph.g2o, report.json, report.md and timing.json. One
/// file that can't be written does not keep the others from it.
/// @return one sentence for each fault; empty where all went well
[[nodiscard]] std::vector<std::string> saveResults(
    const std::filesystem::path& folder, const RunRecord& record, const evaluation::Report& report,
    const std::vector<evaluation::TimingFigures>& timings);

}  // namespace omega_slam

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "omega_slam/evaluation/report.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::results {

/// All that a run leaves behind, in the frame of its map.
struct RunResults {
  grid::OccupancyGrid map;
  geometry::Trajectory estimate;  ///< `T_map_base` at every scan
  geometry::Trajectory truth;     ///< the same, true; empty where nobody knows
  graph::PoseGraph graph;
  evaluation::Report report;
  std::vector<evaluation::TimingFigures> timings;
};

/// Writes map.pgm, map.yaml, map.png, trajectory.tum, graph.g2o, report.md, report.json and
/// timing.json, each atomically; the folder is made if it is missing. Without a map there are no
/// map files. The same results give the same bytes.
/// @return a sentence for each file that could not be written; empty if all is well
[[nodiscard]] std::vector<std::string> writeResults(const std::filesystem::path& folder,
                                                    const RunResults& results);

}  // namespace omega_slam::results

#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "omega_slam/evaluation/report.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/io/scan_source.h"
#include "omega_slam/slam/pipeline.h"

namespace omega_slam::experiments {

/// What slam::Pipeline has made of a recording, and what that took.
struct SlamRun {
  geometry::Trajectory trajectory;  ///< `T_map_base` at every scan
  std::vector<slam::KeyframePtr> keyframes;
  graph::PoseGraph graph;
  std::vector<double> weights;                     ///< of its constraints
  std::vector<graph::Constraint> withdrawn_loops;  ///< no part of the graph
  std::vector<graph::Constraint> folded_loops;     ///< part of other constraints
  grid::OccupancyGrid map;
  std::size_t rejected{0};      ///< scans
  std::vector<double> seconds;  ///< [s] of processor time, for each scan
  double cpu_seconds{0.0};      ///< [s] of all: scans, last solve, trajectory and map
};

/// Told after each scan: the pipeline, and the processor time that the scan took [s].
using ScanWatcher = std::function<void(const slam::Pipeline&, double)>;

/// Everything on, as omega_slam_offline does it: every scan, loops, the last solve, the map.
[[nodiscard]] SlamRun runSlam(const std::vector<io::ScanRecord>& records,
                              const slam::PipelineConfig& config, const ScanWatcher& watcher = {});

}  // namespace omega_slam::experiments

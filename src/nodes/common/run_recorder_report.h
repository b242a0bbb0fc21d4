#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "nodes/common/run_recorder_accounts.h"
#include "nodes/common/run_recorder_record.h"
#include "omega_slam/evaluation/report.h"
#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam {

/// The world as it truly is, for comparison.
struct TrueWorld {
  std::string name;
  grid::OccupancyGrid map;
  Eigen::Vector2d start{0.0, 0.0};  ///< [m] where the robot begins, in the map's frame
};

/// @throws std::runtime_error with one sentence if the world file or its map can't be read
[[nodiscard]] TrueWorld loadTrueWorld(const std::string& path);

/// How a run ended.
struct RunEnding {
  std::string reason;     ///< a phrase such as "route done"
  bool settled{false};    ///< whether graph and map had caught up by then
  double wall_time{0.0};  ///< [s] that the run took
};

/// Compares what came of a run with the truth, and says what there is to say of it.
[[nodiscard]] evaluation::Report makeReport(const RunRecord& record, const RunEnding& ending,
                                            const RunAccounts& accounts,
                                            const std::optional<TrueWorld>& world);

/// The main figures in two or three lines, for the terminal.
[[nodiscard]] std::string formatClosing(const evaluation::Report& report, const RunEnding& ending);

}  // namespace omega_slam

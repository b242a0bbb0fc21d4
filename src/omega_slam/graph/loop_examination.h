#pragma once

#include <optional>
#include <vector>

#include "omega_slam/graph/graph_system.h"
#include "omega_slam/graph/loop_fit.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/weighing.h"

namespace omega_slam::graph {

/// Fits of many loops at a graph's poses, which should be the solution: of those that count, each
/// to the graph without it, and of those that do not, to the graph. One factorisation and one
/// SelectedInverse for all.
/// @param weighing a loop counts where its weight is above 0
/// @param system prepared for the graph with all its constraints
/// @param loops indices of constraints
/// @return none where Omega is singular
[[nodiscard]] std::optional<std::vector<LoopFit>> examine(const PoseGraph& graph,
                                                          const Weighing& weighing,
                                                          GraphSystem& system,
                                                          const std::vector<std::size_t>& loops);

}  // namespace omega_slam::graph

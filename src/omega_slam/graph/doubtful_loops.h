#pragma once

#include <cstddef>
#include <vector>

#include "omega_slam/graph/loop_consistency.h"
#include "omega_slam/graph/loop_fit.h"
#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// What is known of a loop while it is not certain which ones are false.
struct DoubtfulLoop {
  std::size_t constraint{0};            ///< index
  std::vector<std::size_t> supporters;  ///< indices of doubtful loops that agree with it
  bool is_tie{false};                   ///< without it, a part of the graph would lie nowhere
  bool is_believed{false};
  bool is_presumed{false};  ///< believed for want of better
  int withdrawals{0};
  LoopFit fit;
};

/// All loops of a graph. Only those settled are presumed to be right, if no loop that agrees with
/// them is in question; and ties are believed: of those that could tie a part of the graph to the
/// rest, a settled one or that with most support.
/// @param settled constraints by index; empty where none is
[[nodiscard]] std::vector<DoubtfulLoop> doubtfulLoops(const PoseGraph& graph,
                                                      const SupportConfig& config,
                                                      const std::vector<bool>& settled = {});

/// The graph without the loops that are not believed.
[[nodiscard]] PoseGraph believedGraph(const PoseGraph& graph,
                                      const std::vector<DoubtfulLoop>& loops);

}  // namespace omega_slam::graph

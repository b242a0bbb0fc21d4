#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "omega_slam/graph/loop_doubt.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/robust_loops.h"

namespace omega_slam::slam {

/// Loops by the nodes that they are between.
using LoopSet = std::set<std::pair<graph::NodeId, graph::NodeId>>;

/// A doubt of all loops of a graph, and of loops that were withdrawn from it
/// (graph/robust_loops.h), round by round: the graph may grow meanwhile.
class Doubt {
 public:
  /// @param withdrawn those from `first` on are doubted
  /// @param confirmed by the last doubt; begins with these, if they lie where they say although the
  /// graph is at rest with those in it that do not, so that few rounds are left. None: with no loop
  Doubt(const graph::PoseGraph& graph, const std::vector<graph::Constraint>& withdrawn,
        std::size_t first, const graph::RobustConfig& config,
        const std::optional<LoopSet>& confirmed);

  /// One round. @return false where none was left to do
  bool advance() { return rounds_.advance(); }

  /// All rounds that are left, and what comes of them: loops that the rest contradicts are
  /// withdrawn, others that were come back, poses follow.
  /// @param graph, withdrawn as given, but for what came at their ends since
  /// @return those that are confirmed; none where no answer was found, and all is as before
  [[nodiscard]] std::optional<LoopSet> conclude(graph::PoseGraph& graph,
                                                std::vector<graph::Constraint>& withdrawn);

 private:
  void sortOut(const std::vector<bool>& is_contradicted, graph::PoseGraph& graph,
               std::vector<graph::Constraint>& withdrawn) const;

  std::size_t nodes_;     ///< that there were at the beginning
  std::size_t tied_;      ///< constraints of the graph
  std::size_t first_;     ///< of the withdrawn ones
  graph::PoseGraph all_;  ///< constraints of the graph, then those withdrawn
  graph::LoopDoubt rounds_;
};

}  // namespace omega_slam::slam

#pragma once

#include <optional>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/descent.h"
#include "omega_slam/graph/estimated_part.h"
#include "omega_slam/graph/first_guess.h"
#include "omega_slam/graph/graph_system.h"
#include "omega_slam/graph/loop_judgement.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/robust_loops.h"
#include "omega_slam/graph/weighing.h"

namespace omega_slam::graph {

/// solveWithDoubtfulLoops(), round by round: who has more to do can spread it.
class LoopDoubt {
 public:
  /// @param graph finite, with constraints
  /// @param config valid
  /// @param settled as there
  LoopDoubt(const PoseGraph& graph, const RobustConfig& config,
            const std::vector<bool>& settled = {});

  /// One round. @return false where none was left to do
  bool advance();

  /// All rounds that are left.
  /// @param graph its nodes follow; later ones stay
  RobustReport finish(PoseGraph& graph);

 private:
  [[nodiscard]] FirstGuess guess() const;
  [[nodiscard]] DescentEnd solveRound(FirstGuess guess, const DescentLimits& limits);
  [[nodiscard]] bool updateFits();
  [[nodiscard]] bool settle();
  void fillReport(RobustReport& report) const;

  RobustConfig config_;
  bool is_most_settled_;
  EstimatedPart part_;  ///< of the graph given
  PoseGraph graph_;     ///< that part, at the last solution
  double initial_chi_square_;
  LoopJudgement judgement_;
  Weighing weighing_;
  GraphSystem system_;
  DescentEnd end_{DescentEnd::kIterationLimit};  ///< of the last solve
  std::optional<bool> goes_on_{true};            ///< none where Omega is singular
  int rounds_{0};
  int iterations_{0};
};

}  // namespace omega_slam::graph

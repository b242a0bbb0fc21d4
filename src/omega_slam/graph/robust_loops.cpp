#include "omega_slam/graph/robust_loops.h"

#include <cmath>

#include "omega_slam/geometry/validation.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/loop_doubt.h"

namespace omega_slam::graph {

std::vector<std::string> RobustConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("gate", gate, 0.0);
  violations.requireAbove("accidents", accidents, 0.0);
  violations.requireWithin("supported_chance", supported_chance, 0.0, 1.0);
  violations.requireAbove("support.gate", support.gate, 0.0);
  violations.requireAtLeast("max_rounds", max_rounds, 1);
  violations.requireAtLeast("max_iterations", limits.max_iterations, 1);
  violations.requireWithin("relative_gain", limits.relative_gain, 0.0, 1.0);
  return violations.sentences();
}

std::string toString(LoopStanding standing) {
  switch (standing) {
    case LoopStanding::kConfirmed:
      return "confirmed";
    case LoopStanding::kLikely:
      return "likely";
    case LoopStanding::kOnlyTie:
      return "only tie";
    case LoopStanding::kContradicted:
      return "contradicted";
    case LoopStanding::kUnconfirmed:
      return "unconfirmed";
  }
  return "unknown";
}

RobustReport solveWithDoubtfulLoops(PoseGraph& graph, const RobustConfig& config,
                                    const std::vector<bool>& settled) {
  geometry::throwIfAny(config.validate());
  if (graph.constraints.empty()) {
    return {};
  }
  if (!std::isfinite(chiSquare(graph))) {
    RobustReport report;
    report.solution.status = SolveStatus::kFailed;
    report.solution.message = "a pose or a constraint is not finite";
    return report;
  }
  return LoopDoubt(graph, config, settled).finish(graph);
}

}  // namespace omega_slam::graph

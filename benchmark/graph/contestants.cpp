#include "graph/contestants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "experiments/cpu_timer.h"
#include "omega_slam/graph/solver.h"

namespace omega_slam::experiments {

Solution solveOurselves(const graph::PoseGraph& graph) {
  graph::SolverConfig config;
  config.limits = {kMaxIterations, kRelativeGain};
  config.kernels.loop.kind = graph::KernelKind::kNone;
  graph::GraphSolver solver(config);
  graph::PoseGraph solved = graph;
  const CpuTimer timer;
  const graph::SolveReport report = solver.solve(solved);
  Solution solution{{}, report.iterations, timer.seconds()};
  if (report.status != graph::SolveStatus::kFailed) {
    solution.poses = std::move(solved.poses);
  }
  return solution;
}

std::vector<std::string> graphContestantNames() {
  return ceresContestant() ? std::vector<std::string>{"ours", "ceres"}
                           : std::vector<std::string>{"ours"};
}

GraphContestant graphContestant(const std::string& name) {
  if (name == "ours") {
    return solveOurselves;
  }
  if (auto ceres = ceresContestant(); ceres && name == "ceres") {
    return *ceres;
  }
  throw std::invalid_argument(fmt::format("'{}' is not a solver here; known are {}", name,
                                          fmt::join(graphContestantNames(), ", ")));
}

}  // namespace omega_slam::experiments

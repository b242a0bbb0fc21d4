#include "graph/online_drive.h"

#include <fmt/format.h>

#include <iterator>
#include <numeric>
#include <utility>

#include "experiments/cpu_timer.h"
#include "graph/arrivals.h"
#include "omega_slam/graph/incremental_solver.h"

namespace omega_slam::experiments {

using geometry::Pose2;
using graph::Constraint;

namespace {

Pose2 guessOf(const graph::PoseGraph& graph, const Constraint& tie) {
  return tie.from < tie.to ? graph.poses[tie.from] * tie.T_from_to
                           : graph.poses[tie.to] * tie.T_from_to.inverse();
}

/// Processor time of an action.
template <typename Action>
double secondsOf(Action act) {
  const CpuTimer timer;
  act();
  return timer.seconds();
}

}  // namespace

OnlineDrive playOnline(const graph::PoseGraph& graph) {
  graph::IncrementalConfig config;
  config.solver.limits = {kMaxIterations, kRelativeGain};
  config.solver.kernels.loop.kind = graph::KernelKind::kNone;
  graph::IncrementalSolver solver(config);
  OnlineDrive drive;
  for (const auto& arrival : arrivalsOf(graph)) {
    const Pose2 guess = arrival.ties.empty() ? graph.poses[drive.seconds.size()]
                                             : guessOf(solver.graph(), arrival.ties.front());
    drive.seconds.push_back(secondsOf([&] {
      solver.addNode(guess, arrival.ties);
      if (!arrival.loops.empty()) {
        solver.addConstraints(arrival.loops);
      }
    }));
  }
  drive.seconds.back() += secondsOf([&] { solver.finish(); });
  drive.solution.poses = solver.graph().poses;
  drive.solution.iterations = static_cast<int>(drive.seconds.size());
  drive.solution.seconds = std::accumulate(drive.seconds.begin(), drive.seconds.end(), 0.0);
  return drive;
}

std::string updateTable(const OnlineDrive& drive) {
  std::string text = "pose,microseconds\n";
  for (std::size_t pose = 0; pose < drive.seconds.size(); ++pose) {
    fmt::format_to(std::back_inserter(text), "{},{:.1f}\n", pose, 1e6 * drive.seconds[pose]);
  }
  return text;
}

}  // namespace omega_slam::experiments

#include "graph/online_drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "experiments/cpu_timer.h"
#include "omega_slam/graph/incremental_solver.h"

namespace omega_slam::experiments {

using geometry::Pose2;
using graph::Constraint;
using graph::NodeId;

namespace {

/// By the later of their two nodes; the one to the latest of the earlier nodes comes first.
std::vector<std::vector<Constraint>> constraintsByArrival(const graph::PoseGraph& graph) {
  std::vector<std::vector<Constraint>> arriving(graph.poses.size());
  for (const Constraint& constraint : graph.constraints) {
    arriving[std::max(constraint.from, constraint.to)].push_back(constraint);
  }
  for (std::vector<Constraint>& group : arriving) {
    const auto is_later = [](const Constraint& a, const Constraint& b) {
      return std::min(a.from, a.to) > std::min(b.from, b.to);
    };
    std::stable_sort(group.begin(), group.end(), is_later);
  }
  return arriving;
}

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
  const auto arriving = constraintsByArrival(graph);
  OnlineDrive drive;
  for (std::size_t node = 0; node < arriving.size(); ++node) {
    const auto& group = arriving[node];
    const auto loops = group.empty() ? group.begin() : std::next(group.begin());
    const std::vector<Constraint> ties(group.begin(), loops);
    const Pose2 guess = ties.empty() ? graph.poses[node] : guessOf(solver.graph(), ties.front());
    const std::vector<Constraint> others(loops, group.end());
    drive.seconds.push_back(secondsOf([&] {
      solver.addNode(guess, ties);
      if (!others.empty()) {
        solver.addConstraints(others);
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

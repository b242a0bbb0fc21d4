#include "graph/solve_account.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "experiments/cpu_timer.h"
#include "omega_slam/graph/linearization.h"

namespace omega_slam::experiments {

namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

std::string accountHead() {
  return "graph,guess,solver,poses,constraints,initial_chi_square,chi_square,own_cost,iterations,"
         "milliseconds,guess_milliseconds,peak_mb";
}

std::string accountRow(const SolveAccount& account) {
  return fmt::format("{},{},{},{},{},{:.9g},{:.9g},{:.9g},{},{:.6g},{:.6g},{:.4g}", account.graph,
                     account.guess, account.solver, account.poses, account.constraints,
                     account.initial_chi_square, account.chi_square, account.own_cost,
                     account.iterations, account.milliseconds, account.guess_milliseconds,
                     account.peak_megabytes);
}

SolveAccount accountFor(const graph::PoseGraph& graph, const SolveTask& task) {
  const GraphContestant contestant = graphContestant(task.solver);
  graph::PoseGraph guessed = graph;
  const CpuTimer timer;
  graph::applyGuess(guessed, task.guess);
  SolveAccount account;
  account.guess_milliseconds = 1e3 * timer.seconds();
  account.graph = task.name;
  account.guess = graph::guessNames().at(static_cast<std::size_t>(task.guess));
  account.solver = task.solver;
  std::vector<double> seconds;
  graph::PoseGraph solved;
  for (int k = 0; k < task.repetitions; ++k) {
    Solution solution = contestant(guessed);
    seconds.push_back(solution.seconds);
    account.iterations = solution.iterations;
    solved.poses = std::move(solution.poses);
  }
  account.milliseconds = 1e3 * median(seconds);
  account.peak_megabytes = peakMegabytes();
  score(guessed, solved, account);
  account.own_cost = account.chi_square;
  return account;
}

void score(const graph::PoseGraph& graph, const graph::PoseGraph& solved, SolveAccount& account) {
  account.poses = graph.poses.size();
  account.constraints = graph.constraints.size();
  account.initial_chi_square = graph::chiSquare(graph);
  account.chi_square = std::numeric_limits<double>::infinity();
  if (solved.poses.empty()) {
    return;
  }
  if (solved.poses.size() != graph.poses.size()) {
    throw std::runtime_error(fmt::format("the solution has {} poses, the graph {}",
                                         solved.poses.size(), graph.poses.size()));
  }
  graph::PoseGraph at_end = graph;
  at_end.poses = solved.poses;
  account.chi_square = graph::chiSquare(at_end);
}

double peakMegabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    std::istringstream words(line);
    std::string key;
    double kilobytes = 0.0;
    if (words >> key >> kilobytes && key == "VmHWM:") {
      return kilobytes / 1024.0;
    }
  }
  return 0.0;
}

}  // namespace omega_slam::experiments

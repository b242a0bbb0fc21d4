// Solves a 2D pose graph from a file: the solver that the robot's back end uses, for any graph.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "omega_slam/evaluation/graph_picture.h"
#include "omega_slam/graph/first_guess.h"
#include "omega_slam/graph/graph_file.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/robust_loops.h"
#include "omega_slam/graph/solver.h"
#include "omega_slam/graph/thinning.h"
#include "omega_slam/grid/atomic_file.h"

namespace omega_slam {
namespace {

using Clock = std::chrono::steady_clock;

struct Arguments {
  std::string input;
  std::string output;
  std::string method{"gauss-newton"};
  std::string kernel{"none"};
  std::string guess{"best"};
  std::string loops{"believe"};
  std::string plot;
  std::string residuals;
  double width{1.0};
  double thin{0.0};
  int iterations{100};
};

const std::vector<std::string> kMethods = {"gauss-newton", "levenberg-marquardt", "linear"};

void declare(CLI::App& app, Arguments& arguments) {
  app.add_option("INPUT", arguments.input, "graph, in g2o's or TORO's format")->required();
  app.add_option("OUTPUT", arguments.output,
                 "solved graph; .toro and .graph are TORO's format, .tum is the poses alone with "
                 "ids as stamps, all else g2o's");
  app.add_option("--method", arguments.method, "how to solve; linear is the paper's equations")
      ->check(CLI::IsMember(kMethods))
      ->capture_default_str();
  app.add_option("--kernel", arguments.kernel, "what a loop costs that lies far off")
      ->check(CLI::IsMember(graph::kernelNames()))
      ->capture_default_str();
  app.add_option("--width", arguments.width,
                 "from how many standard deviations on a loop lies far off")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--guess", arguments.guess,
                 "where to begin; best is the one with the least chi-square")
      ->check(CLI::IsMember(graph::guessNames()))
      ->capture_default_str();
  app.add_option("--loops", arguments.loops,
                 "doubt finds out which loops are false and solves without them; it makes its own "
                 "first guess, and takes neither method nor kernel")
      ->check(CLI::IsMember({"believe", "doubt"}))
      ->capture_default_str();
  app.add_option("--iterations", arguments.iterations, "at most so many")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--thin", arguments.thin,
                 "then remove nodes of places [m across] that have many, and solve again")
      ->check(CLI::PositiveNumber);
  app.add_option("--plot", arguments.plot, "picture of the graph before and after (PNG)");
  app.add_option("--residuals", arguments.residuals,
                 "table of all constraints with chi-square and weight (CSV)");
}

graph::SolverConfig solverConfig(const Arguments& arguments) {
  graph::SolverConfig config;
  const auto method = std::find(kMethods.begin(), kMethods.end(), arguments.method);
  config.method = static_cast<graph::SolverMethod>(method - kMethods.begin());
  config.limits.max_iterations = arguments.iterations;
  config.kernels.loop = {graph::kernelFromName(arguments.kernel), arguments.width};
  return config;
}

std::string toTum(const graph::GraphFile& file) {
  std::string text;
  for (std::size_t node = 0; node < file.graph.poses.size(); ++node) {
    const geometry::Pose2& pose = file.graph.poses[node];
    text += fmt::format("{} {:.9g} {:.9g} 0 0 0 {:.9g} {:.9g}\n", file.ids[node], pose.x, pose.y,
                        std::sin(0.5 * pose.theta), std::cos(0.5 * pose.theta));
  }
  return text;
}

std::string toCsv(const graph::GraphFile& file, const graph::SolveReport& report) {
  std::string text = "from,to,kind,chi_square,weight\n";
  for (std::size_t k = 0; k < file.graph.constraints.size(); ++k) {
    const graph::Constraint& constraint = file.graph.constraints[k];
    text += fmt::format("{},{},{},{:.6g},{:.4g}\n", file.ids[constraint.from],
                        file.ids[constraint.to], graph::toString(constraint.kind),
                        graph::chiSquare(file.graph, constraint), report.weights.at(k));
  }
  return text;
}

void throwIfFailed(const std::string& failure) {
  if (!failure.empty()) {
    throw std::runtime_error(failure);
  }
}

void printReport(const graph::SolveReport& report, double seconds) {
  for (std::size_t i = 0; i < report.chi_squares.size(); ++i) {
    fmt::print("iteration {:3d}: chi-square {:.6f}\n", i + 1, report.chi_squares[i]);
  }
  if (!report.message.empty()) {
    fmt::print("Note: {}.\n", report.message);
  }
  const bool is_at_rest = report.status == graph::SolveStatus::kConverged;
  fmt::print("{} after {} iterations, {} factorisations, {:.2f} ms: chi-square {:.6f}\n",
             is_at_rest ? "Converged" : "Still moving", report.iterations, report.factorizations,
             1e3 * seconds, report.chi_square);
  const auto doubted = std::count_if(report.weights.begin(), report.weights.end(),
                                     [](double weight) { return weight < 0.5; });
  if (doubted > 0) {
    fmt::print("{} constraints have a weight below one half.\n", doubted);
  }
}

void writeOutputs(const Arguments& arguments, const graph::GraphFile& before,
                  const graph::GraphFile& after, const graph::SolveReport& report) {
  if (!arguments.output.empty()) {
    const bool is_tum = std::filesystem::path(arguments.output).extension() == ".tum";
    throwIfFailed(grid::writeFileAtomically(
        arguments.output, is_tum ? toTum(after) : graph::toText(after, arguments.output)));
  }
  if (!arguments.residuals.empty()) {
    throwIfFailed(grid::writeFileAtomically(arguments.residuals, toCsv(after, report)));
  }
  if (!arguments.plot.empty()) {
    throwIfFailed(evaluation::writeGraphPicture(
        arguments.plot,
        {{before.graph, {}, fmt::format("before: chi-square {:.6g}", report.initial_chi_square)},
         {after.graph, report.weights,
          fmt::format("after: chi-square {:.6g}", report.chi_square)}}));
  }
}

/// Removes what adds little, and solves what is left.
graph::SolveReport thin(double spacing, const graph::SolverConfig& config, graph::GraphFile& file) {
  graph::ThinningConfig thinning;
  thinning.spacing = spacing;
  const std::size_t nodes = file.graph.poses.size();
  const graph::ThinningReport thinned = graph::thinOut(file.graph, thinning);
  std::vector<graph::NodeId> ids;
  for (const graph::NodeId node : thinned.kept) {
    ids.push_back(file.ids[node]);
  }
  file.ids = std::move(ids);
  fmt::print("Thinned out: {} of {} nodes are left, {:.3g} nats were lost.\n", file.ids.size(),
             nodes, thinned.divergence);
  return graph::solve(file.graph, config);
}

graph::SolveReport solveBelieving(graph::PoseGraph& graph, const Arguments& arguments) {
  const auto guess = graph::applyGuess(graph, graph::guessFromName(arguments.guess));
  graph::SolveReport report = graph::solve(graph, solverConfig(arguments));
  fmt::print("first guess ({}): chi-square {:.6f}\n",
             graph::guessNames().at(static_cast<std::size_t>(guess)), report.initial_chi_square);
  return report;
}

graph::SolveReport solveDoubting(graph::GraphFile& file, const Arguments& arguments) {
  graph::RobustConfig config;
  config.limits.max_iterations = arguments.iterations;
  const graph::RobustReport report = graph::solveWithDoubtfulLoops(file.graph, config);
  for (const graph::LoopVerdict& loop : report.loops) {
    if (!loop.isBelieved()) {
      const graph::Constraint& constraint = file.graph.constraints[loop.constraint];
      fmt::print("loop {} - {} is {}: {:.1f} standard deviations off\n", file.ids[constraint.from],
                 file.ids[constraint.to], toString(loop.standing), std::sqrt(loop.squared));
    }
  }
  return report.solution;
}

/// Removes the loops that are not believed.
void dropDoubted(const std::vector<double>& weights, graph::PoseGraph& graph) {
  std::vector<graph::Constraint> believed;
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    if (weights[k] > 0.0) {
      believed.push_back(graph.constraints[k]);
    }
  }
  graph.constraints = std::move(believed);
}

int run(const Arguments& arguments) {
  const graph::GraphFile before = graph::loadGraph(arguments.input);
  graph::GraphFile after = before;
  fmt::print("{}: {} nodes, {} constraints, chi-square {:.6f}\n", arguments.input,
             before.graph.poses.size(), before.graph.constraints.size(),
             graph::chiSquare(before.graph));
  const auto start = Clock::now();
  const bool is_doubting = arguments.loops == "doubt";
  graph::SolveReport report =
      is_doubting ? solveDoubting(after, arguments) : solveBelieving(after.graph, arguments);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (report.status == graph::SolveStatus::kFailed) {
    throw std::runtime_error(report.message + ".");
  }
  printReport(report, seconds);
  if (arguments.thin > 0.0) {
    if (is_doubting) {
      dropDoubted(report.weights, after.graph);
    }
    report = thin(arguments.thin, solverConfig(arguments), after);
  }
  report.initial_chi_square = graph::chiSquare(before.graph);
  writeOutputs(arguments, before, after, report);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  CLI::App app(
      "Solves a 2D pose graph: finds the poses for which the sum of e^T Omega e over all "
      "constraints (chi-square, without a factor 1/2) is least.");
  omega_slam::Arguments arguments;
  omega_slam::declare(app, arguments);
  CLI11_PARSE(app, argc, argv);
  try {
    return omega_slam::run(arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "omega_slam_optimize: {}\n", error.what());
    return EXIT_FAILURE;
  }
}

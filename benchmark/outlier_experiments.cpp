// False loops in graphs, and what solvers make of them. scripts/experiments runs it for each.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <string>

#include "experiments/program.h"
#include "graph/outliers.h"
#include "omega_slam/graph/graph_file.h"

namespace omega_slam::experiments {
namespace {

struct Arguments {
  std::string graph;
  std::string name;
  OutlierSweep sweep;
};

void declare(CLI::App& app, Arguments& arguments) {
  app.add_option("GRAPH", arguments.graph, "g2o's format, or TORO's; all its loops are true")
      ->required();
  app.add_option("--name", arguments.name, "of the graph; default: that of its file");
  app.add_option("--solver", arguments.sweep.solver)
      ->check(CLI::IsMember(doubtingSolverNames()))
      ->capture_default_str();
  app.add_option("--counts", arguments.sweep.counts, "of false loops")->capture_default_str();
  app.add_option("--groups", arguments.sweep.groups, "sizes, within which false loops agree")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seeds", arguments.sweep.seeds, "trials of each count and size")
      ->capture_default_str();
}

void run(const Arguments& arguments) {
  const std::string name = arguments.name.empty()
                               ? std::filesystem::path(arguments.graph).stem().string()
                               : arguments.name;
  const CleanGraph clean = cleanGraph(name, graph::loadGraph(arguments.graph).graph);
  fmt::print("{}\n", outlierHead());
  sweepOutliers(clean, arguments.sweep, [](const OutlierAccount& account) {
    fmt::print("{}\n", outlierRow(account));
    std::fflush(stdout);
  });
}

}  // namespace
}  // namespace omega_slam::experiments

int main(int argc, char** argv) {
  CLI::App app(
      "Adds false loops to a graph, solves it, and prints a row (CSV) for each trial; "
      "scripts/experiments runs it for all solvers.");
  omega_slam::experiments::Arguments arguments;
  omega_slam::experiments::declare(app, arguments);
  return omega_slam::experiments::runProgram(app, argc, argv,
                                             [&] { omega_slam::experiments::run(arguments); });
}

// The graph's solver beside its peers. Solves one graph by one solver; scripts/experiments runs
// them all.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "experiments/program.h"
#include "graph/contestants.h"
#include "graph/long_drive.h"
#include "graph/manhattan_world.h"
#include "graph/online_drive.h"
#include "graph/solve_account.h"
#include "omega_slam/graph/first_guess.h"
#include "omega_slam/graph/graph_file.h"
#include "omega_slam/grid/atomic_file.h"

namespace omega_slam::experiments {
namespace {

struct Arguments {
  std::string graph;
  std::string solved;
  std::string out;
  std::string times;
  std::string guess{"best"};
  int repetitions{5};
  SolveAccount account;  ///< as far as another program has written it
  ManhattanConfig manhattan;
  LongDriveConfig hours;
};

void declareGuess(CLI::App& command, Arguments& arguments) {
  command.add_option("--guess", arguments.guess, "where the solver begins")
      ->check(CLI::IsMember(graph::guessNames()))
      ->capture_default_str();
}

void declareGraph(CLI::App& command, Arguments& arguments) {
  command.add_option("GRAPH", arguments.graph, "g2o's format, or TORO's")->required();
  command.add_option("--name", arguments.account.graph, "of the graph; default: that of its file");
}

void declareSolve(CLI::App& app, Arguments& arguments) {
  CLI::App& solve = *app.add_subcommand("solve", "a graph by ours or Ceres; prints a row (CSV)");
  declareGraph(solve, arguments);
  solve.add_option("--solver", arguments.account.solver)
      ->required()
      ->check(CLI::IsMember(graphContestantNames()));
  declareGuess(solve, arguments);
  solve.add_option("--repetitions", arguments.repetitions, "of which the median time counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void declareOnline(CLI::App& app, Arguments& arguments) {
  CLI::App& online =
      *app.add_subcommand("online", "plays a graph to ours, pose by pose; prints a row (CSV)");
  declareGraph(online, arguments);
  online.add_option("--times", arguments.times, "to write: pose, microseconds")->required();
}

void declareScore(CLI::App& app, Arguments& arguments) {
  CLI::App& score = *app.add_subcommand(
      "score", "what another program has solved, by our chi-square; prints a row (CSV)");
  declareGraph(score, arguments);
  score.add_option("--solver", arguments.account.solver)->required();
  score.add_option("SOLVED", arguments.solved, "its poses; without them, it has failed");
  SolveAccount& account = arguments.account;
  score.add_option("--guess", account.guess, "where it began")->required();
  score.add_option("--own-cost", account.own_cost, "twice the cost that it minimises itself");
  score.add_option("--iterations", account.iterations);
  score.add_option("--milliseconds", account.milliseconds, "of the solve alone");
  score.add_option("--peak", account.peak_megabytes, "memory [MB]");
}

void declareWriters(CLI::App& app, Arguments& arguments) {
  CLI::App& write = *app.add_subcommand("guess", "writes a graph with its first guess (g2o)");
  write.add_option("GRAPH", arguments.graph, "g2o's format, or TORO's")->required();
  declareGuess(write, arguments);
  CLI::App& grid = *app.add_subcommand("grid", "writes the graph of a drive through streets (g2o)");
  grid.add_option("--poses", arguments.manhattan.poses)->check(CLI::PositiveNumber);
  grid.add_option("--seed", arguments.manhattan.seed);
  for (CLI::App* command : {&write, &grid}) {
    command->add_option("--out", arguments.out, "file")->required();
  }
}

void declareHours(CLI::App& app, LongDriveConfig& hours) {
  CLI::App& command = *app.add_subcommand(
      "hours", "drives in the same streets for hours; prints a row (CSV) for each");
  command.add_option("--keyframes", hours.keyframes)->check(CLI::PositiveNumber);
  command.add_option("--per-hour", hours.keyframes_an_hour, "keyframes")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--keyframes-per-place", hours.back_end.thinning.nodes_per_place)
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void printRow(const SolveAccount& account) {
  fmt::print("{}\n{}\n", accountHead(), accountRow(account));
}

void runSolve(const Arguments& arguments) {
  printRow(accountFor(graph::loadGraph(arguments.graph).graph,
                      {arguments.account.graph, graph::guessFromName(arguments.guess),
                       arguments.account.solver, arguments.repetitions}));
}

void write(const std::string& path, const std::string& text) {
  const std::string failure = grid::writeFileAtomically(path, text);
  if (!failure.empty()) {
    throw std::runtime_error(failure);
  }
}

void runOnline(Arguments& arguments) {
  const graph::PoseGraph graph = graph::loadGraph(arguments.graph).graph;
  const OnlineDrive drive = playOnline(graph);
  write(arguments.times, updateTable(drive));
  SolveAccount& account = arguments.account;
  account.guess = "online";
  account.solver = "ours";
  account.iterations = drive.solution.iterations;
  account.milliseconds = 1e3 * drive.solution.seconds;
  account.peak_megabytes = peakMegabytes();
  graph::PoseGraph solved;
  solved.poses = drive.solution.poses;
  score(graph, solved, account);
  account.own_cost = account.chi_square;
  printRow(account);
}

void runScore(Arguments& arguments) {
  const graph::PoseGraph solved =
      arguments.solved.empty() ? graph::PoseGraph{} : graph::loadGraph(arguments.solved).graph;
  score(graph::loadGraph(arguments.graph).graph, solved, arguments.account);
  printRow(arguments.account);
}

void run(const CLI::App& app, Arguments& arguments) {
  if (arguments.account.graph.empty()) {
    arguments.account.graph = std::filesystem::path(arguments.graph).stem().string();
  }
  if (app.got_subcommand("solve")) {
    runSolve(arguments);
  } else if (app.got_subcommand("online")) {
    runOnline(arguments);
  } else if (app.got_subcommand("score")) {
    runScore(arguments);
  } else if (app.got_subcommand("hours")) {
    printLongDrive(arguments.hours, [](const std::string& text) {
      fmt::print("{}", text);
      std::fflush(stdout);
    });
  } else if (app.got_subcommand("guess")) {
    graph::GraphFile file = graph::loadGraph(arguments.graph);
    graph::applyGuess(file.graph, graph::guessFromName(arguments.guess));
    write(arguments.out, graph::toG2o(file));
  } else {
    write(arguments.out, graph::toG2o(driveManhattan(arguments.manhattan).graph));
  }
}

}  // namespace
}  // namespace omega_slam::experiments

int main(int argc, char** argv) {
  CLI::App app("Experiments on the solver of pose graphs; scripts/experiments runs them all.");
  app.require_subcommand(1);
  omega_slam::experiments::Arguments arguments;
  omega_slam::experiments::declareSolve(app, arguments);
  omega_slam::experiments::declareOnline(app, arguments);
  omega_slam::experiments::declareScore(app, arguments);
  omega_slam::experiments::declareWriters(app, arguments);
  omega_slam::experiments::declareHours(app, arguments.hours);
  return omega_slam::experiments::runProgram(app, argc, argv,
                                             [&] { omega_slam::experiments::run(app, arguments); });
}

// The paper's experiments on scan matching (section 7.3), and matchers against their peers.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/consistency.h"
#include "experiments/elimination.h"
#include "experiments/error_curves.h"
#include "experiments/program.h"
#include "experiments/reliability.h"
#include "omega_slam/matching/matcher_factory.h"

namespace omega_slam::experiments {
namespace {

/// A line for whoever waits, each percent.
void report(std::size_t done, std::size_t all) {
  if (100 * done / all != 100 * (done - 1) / all) {
    fmt::print("progress {} {}\n", done, all);
    std::fflush(stdout);
  }
}

struct Arguments {
  std::string map;
  std::string log;
  std::string name{"world"};
  std::string noise{"translation"};
  std::string out{"."};
  std::size_t scans{100};
  std::size_t levels{315};
  std::uint32_t seed{1};
  std::vector<std::string> matchers;
};

CLI::App* declareExperiment(CLI::App& app, const std::string& name, const std::string& purpose,
                            Arguments& arguments) {
  CLI::App* experiment = app.add_subcommand(name, purpose);
  experiment->add_option("--map", arguments.map, "map_server map to take scans in");
  experiment->add_option("--name", arguments.name, "of map or log, for the names of the tables");
  experiment->add_option("--scans", arguments.scans, "places, or pairs of scans")
      ->check(CLI::PositiveNumber);
  experiment->add_option("--seed", arguments.seed, "of every random number");
  experiment->add_option("--matchers", arguments.matchers, "default: all")->delimiter(',');
  experiment->add_option("--out", arguments.out, "folder for the tables");
  return experiment;
}

void declare(CLI::App& app, Arguments& arguments) {
  app.require_subcommand(1);
  app.add_subcommand("list", "names of the matchers, one a line");
  declareExperiment(app, "errors", "squared error against displacement", arguments);
  CLI::App* elimination =
      declareExperiment(app, "elimination", "matches against noise of the odometry", arguments);
  elimination->add_option("--noise", arguments.noise, "translation or rotation")
      ->check(CLI::IsMember({"translation", "rotation"}));
  elimination->add_option("--levels", arguments.levels, "of noise")->check(CLI::PositiveNumber);
  declareExperiment(app, "consistency", "whether covariances are true", arguments);
  declareExperiment(app, "reliability", "time and reliability beside PCL's matchers", arguments)
      ->add_option("--log", arguments.log, "CARMEN log to take scans from, instead of a map");
}

void listMatchers() {
  for (const std::string& name : matching::matcherNames()) {
    fmt::print("{}\n", name);
  }
}

void runOnKeyPairs(const Arguments& arguments) {
  const KeyPairs pairs =
      arguments.log.empty()
          ? strollPairs(loadArena(arguments.name, arguments.map), arguments.scans, arguments.seed)
          : recordedPairs(arguments.log);
  runReliability(arguments.name, pairs, arguments.seed, arguments.matchers, arguments.out, report);
}

void runInArena(const CLI::App& app, const Arguments& arguments) {
  const Arena arena = loadArena(arguments.name, arguments.map);
  if (app.got_subcommand("errors")) {
    runErrorCurves(arena, arguments.scans, arguments.seed, arguments.out);
  } else if (app.got_subcommand("consistency")) {
    runConsistency(arena, {arguments.scans, arguments.seed, arguments.matchers}, arguments.out,
                   report);
  } else {
    const auto noise =
        arguments.noise == "rotation" ? OdometryNoise::kRotation : OdometryNoise::kTranslation;
    runElimination(arena,
                   {noise, arguments.scans, arguments.levels, arguments.seed, arguments.matchers},
                   arguments.out, report);
  }
}

void run(const CLI::App& app, const Arguments& arguments) {
  std::filesystem::create_directories(arguments.out);
  if (app.got_subcommand("list")) {
    listMatchers();
  } else if (app.got_subcommand("reliability")) {
    runOnKeyPairs(arguments);
  } else {
    runInArena(app, arguments);
  }
}

}  // namespace
}  // namespace omega_slam::experiments

int main(int argc, char** argv) {
  CLI::App app("Experiments on scan matching; scripts/experiments runs them all.");
  omega_slam::experiments::Arguments arguments;
  omega_slam::experiments::declare(app, arguments);
  return omega_slam::experiments::runProgram(app, argc, argv,
                                             [&] { omega_slam::experiments::run(app, arguments); });
}

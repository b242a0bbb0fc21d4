// SLAM of real and simulated runs: how true, how fast, and how it takes faults. scripts/experiments
// runs it for each.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "experiments/program.h"
#include "omega_slam/config/slam_config.h"
#include "slam/growth.h"
#include "slam/icp_ratio.h"
#include "slam/log_faults.h"
#include "slam/recording.h"
#include "slam/slam_run.h"
#include "slam/slam_score.h"
#include "slam/walls.h"

namespace omega_slam::experiments {
namespace {

struct Arguments {
  std::string config;
  std::string name{"log"};
  LogFiles files;
  std::string world;
  std::uint64_t first_seed{1};
  std::uint64_t seeds{1};
  std::vector<double> noises{1.0};
  DriveSettings drive;
  std::vector<std::string> faults;
  std::string corrected;
  std::string out{"."};
  int passes{10};
};

slam::PipelineConfig pipelineConfig(const Arguments& arguments) {
  return config::pipelineConfig(
      arguments.config.empty() ? config::SlamConfig{} : config::loadSlamConfig(arguments.config));
}

/// A row of a table goes out as soon as it is known.
void print(const std::string& row) {
  fmt::print("{}\n", row);
  std::fflush(stdout);
}

void declareLog(CLI::App& app, Arguments& arguments) {
  app.add_option("LOG", arguments.files.log, "CARMEN log");
  app.add_option("--name", arguments.name, "by which the table speaks of it");
  app.add_option("--relations", arguments.files.relations, "ground-truth relations");
  app.add_option("--odometry", arguments.files.odometry, "dense odometry 't x y theta'");
}

void declareDrive(CLI::App& app, Arguments& arguments) {
  app.add_option("--world", arguments.world, "world file, whose route is driven");
  app.add_option("--laser", arguments.drive.laser)
      ->check(CLI::IsMember(laserNames()))
      ->capture_default_str();
  app.add_option("--seconds", arguments.drive.seconds, "after which the drive is cut off");
  app.add_option("--first-seed", arguments.first_seed);
  app.add_option("--noise", arguments.noises, "of the odometry, times the default's")
      ->delimiter(',')
      ->check(CLI::PositiveNumber);
}

void runLog(const Arguments& arguments) {
  print("log," + scoreColumns() + ',' + costColumns());
  const Recording recording = readRecording(arguments.name, arguments.files);
  const SlamRun run = runSlam(recording.records, pipelineConfig(arguments));
  print(arguments.name + ',' + scoreCells(scoreRun(recording, run)) + ',' + costCells(run));
}

void runSimulation(const Arguments& arguments) {
  const simulation::LoadedWorld world = simulation::loadWorld(arguments.world);
  print("world,laser,noise,seed," + scoreColumns() + ',' + honestyColumns() + ',' + costColumns());
  for (std::uint64_t k = 0; k < arguments.seeds; ++k) {
    for (const double noise : arguments.noises) {
      DriveSettings settings = arguments.drive;
      settings.noise = noise;
      const std::uint64_t seed = arguments.first_seed + k;
      const Recording recording = simulateRecording(world, settings, seed);
      const SlamRun run = runSlam(recording.records, pipelineConfig(arguments));
      print(fmt::format("{},{},{:g},{},{},{},{}", recording.name, settings.laser, noise, seed,
                        scoreCells(scoreRun(recording, run)),
                        honestyCells(judgeCovariances(recording, run)), costCells(run)));
    }
  }
}

void runHostile(const Arguments& arguments) {
  DriveSettings settings = arguments.drive;
  settings.noise = arguments.noises.front();
  Recording recording = arguments.world.empty()
                            ? readRecording(arguments.name, arguments.files)
                            : simulateRecording(simulation::loadWorld(arguments.world), settings,
                                                arguments.first_seed);
  print("log,fault," + scoreColumns() + ',' + costColumns());
  const Records whole = recording.records;
  for (const std::string& fault : arguments.faults) {
    recording.records = withFault(fault, whole, arguments.first_seed);
    const SlamRun run = runSlam(recording.records, pipelineConfig(arguments));
    print(fmt::format("{},{},{},{}", recording.name, fault, scoreCells(scoreRun(recording, run)),
                      costCells(run)));
  }
}

void runWalls(const Arguments& arguments) {
  fmt::print("{}", compareWalls(readRecording(arguments.name, arguments.files),
                                pipelineConfig(arguments), arguments.corrected, arguments.out));
}

void runGrowth(const Arguments& arguments) {
  fmt::print("{}",
             growthTable(arguments.name, readRecording(arguments.name, arguments.files).records,
                         arguments.passes, pipelineConfig(arguments)));
}

void runRatio(const Arguments& arguments) {
  fmt::print("{}", icpRatioTable(readRecording(arguments.name, arguments.files),
                                 pipelineConfig(arguments)));
}

using Part = std::function<void(const Arguments&)>;

std::map<CLI::App*, Part> declare(CLI::App& app, Arguments& arguments) {
  app.require_subcommand(1);
  app.add_option("--config", arguments.config, "as config/slam.yaml; default: built in");
  CLI::App* log = app.add_subcommand("log", "SLAM of a log: score and cost");
  declareLog(*log, arguments);
  CLI::App* simulation = app.add_subcommand("simulation", "SLAM of drives through a world");
  declareDrive(*simulation, arguments);
  simulation->add_option("--seeds", arguments.seeds, "drives with each noise");
  CLI::App* hostile = app.add_subcommand("hostile", "a log or a drive, spoilt in many ways");
  declareLog(*hostile, arguments);
  declareDrive(*hostile, arguments);
  arguments.faults = faultNames();
  hostile->add_option("--faults", arguments.faults, "default: all")
      ->delimiter(',')
      ->check(CLI::IsMember(faultNames()));
  CLI::App* walls = app.add_subcommand("walls", "how crisp maps are, and pictures of them");
  declareLog(*walls, arguments);
  walls->add_option("--gmapping", arguments.corrected, "the log as gmapping has corrected it");
  walls->add_option("--out", arguments.out, "folder for the pictures");
  CLI::App* growth = app.add_subcommand("growth", "a log to and fro, and what scans cost then");
  declareLog(*growth, arguments);
  growth->add_option("--passes", arguments.passes)->check(CLI::PositiveNumber);
  CLI::App* ratio = app.add_subcommand("ratio", "a scan's time in units of one match by PCL's ICP");
  declareLog(*ratio, arguments);
  return {{log, runLog},     {simulation, runSimulation}, {hostile, runHostile},
          {walls, runWalls}, {growth, runGrowth},         {ratio, runRatio}};
}

}  // namespace
}  // namespace omega_slam::experiments

int main(int argc, char** argv) {
  CLI::App app("Plays runs through the whole of SLAM, and prints what came of them as CSV.");
  omega_slam::experiments::Arguments arguments;
  const auto parts = omega_slam::experiments::declare(app, arguments);
  return omega_slam::experiments::runProgram(app, argc, argv, [&] {
    for (const auto& [command, part] : parts) {
      if (command->parsed()) {
        part(arguments);
      }
    }
  });
}

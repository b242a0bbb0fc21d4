// The paper's comparison of maps with the truth (section 7.3), and our maps beside MRPT's.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/program.h"
#include "maps/grid_peer.h"
#include "maps/map_scores.h"

namespace omega_slam::experiments {
namespace {

struct Arguments {
  std::string map;
  std::string name{"site"};
  std::vector<double> near{0.0, 0.0};
  std::uint64_t seed{1};
  std::string out{"."};
  bool pictures{false};
};

CLI::App* declareExperiment(CLI::App& app, const std::string& name, const std::string& purpose,
                            Arguments& arguments) {
  CLI::App* experiment = app.add_subcommand(name, purpose);
  experiment->add_option("--map", arguments.map, "map_server map of the building")->required();
  experiment->add_option("--name", arguments.name, "of the building, for the names of the tables");
  experiment->add_option("--near", arguments.near, "X Y [m]: the drive begins about there")
      ->expected(2);
  experiment->add_option("--seed", arguments.seed, "of all noise");
  experiment->add_option("--out", arguments.out, "folder for the tables");
  return experiment;
}

void run(const CLI::App& app, const Arguments& arguments) {
  std::filesystem::create_directories(arguments.out);
  const Site site = loadSite(arguments.name, arguments.map, {arguments.near[0], arguments.near[1]});
  if (app.got_subcommand("survey")) {
    runSurvey(site, arguments.seed, {arguments.out, arguments.pictures});
  } else {
    runGridPeer(site, arguments.seed, arguments.out);
  }
}

}  // namespace
}  // namespace omega_slam::experiments

int main(int argc, char** argv) {
  using omega_slam::experiments::declareExperiment;
  CLI::App app("Experiments on maps; scripts/experiments runs them all.");
  omega_slam::experiments::Arguments arguments;
  app.require_subcommand(1);
  declareExperiment(app, "survey", "drives through a building and maps it", arguments)
      ->add_flag("--pictures", arguments.pictures, "draws the maps, too");
  declareExperiment(app, "peer", "the same scans drawn by MRPT, if it is there", arguments);
  return omega_slam::experiments::runProgram(app, argc, argv,
                                             [&] { omega_slam::experiments::run(app, arguments); });
}

// Explorations of a world by strategy and seed, in one process. scripts/experiments runs it for
// each world.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/csv_file.h"
#include "experiments/program.h"
#include "exploration/exploration_run.h"
#include "exploration/place.h"
#include "exploration/watchman_bound.h"
#include "omega_slam/exploration/strategy_factory.h"
#include "omega_slam/simulation/turtlebot.h"

namespace omega_slam::experiments {
namespace {

struct Arguments {
  std::string world;
  std::string urdf;
  std::string name;
  std::vector<std::string> strategies{exploration::strategyNames()};
  int seeds{1};
  int first_seed{1};
  double patience{3600.0};
  bool random_starts{false};
  bool bound{false};
  std::string localisation{"slam"};
  std::string out;
};

/// A strategy and its runs.
struct Share {
  std::string strategy;
  int seeds;
};

/// Of NAME or NAME=N, N > 0; an empty name if it is neither.
Share shareOf(const std::string& text, int usual_seeds) {
  const std::string name = text.substr(0, text.find('='));
  const std::string number = name.size() < text.size() ? text.substr(name.size() + 1) : "";
  const std::vector<std::string> known = exploration::strategyNames();
  int seeds = usual_seeds;
  const bool is_valid =
      std::find(known.begin(), known.end(), name) != known.end() &&
      (name.size() == text.size() || (CLI::detail::lexical_cast(number, seeds) && seeds > 0));
  return {is_valid ? name : "", seeds};
}

std::string checkShare(const std::string& text) {
  return !shareOf(text, 1).strategy.empty()
             ? ""
             : fmt::format("\"{}\" is none of {}, nor one of them with =N.", text,
                           fmt::join(exploration::strategyNames(), ", "));
}

void declare(CLI::App& app, Arguments& arguments) {
  app.add_option("WORLD", arguments.world, "a world file, or a map_server map")->required();
  app.add_option("--urdf", arguments.urdf, "the robot's description")->required();
  app.add_option("--name", arguments.name, "of the world; default: that of its file");
  app.add_option("--strategies", arguments.strategies, "NAME, or NAME=N for N runs of it")
      ->check(checkShare)
      ->delimiter(',');
  app.add_option("--seeds", arguments.seeds, "runs of each strategy")->capture_default_str();
  app.add_option("--first-seed", arguments.first_seed)->capture_default_str();
  app.add_option("--patience", arguments.patience, "[s] simulated, of a run")
      ->capture_default_str();
  app.add_option("--localisation", arguments.localisation, "how the robot knows where it is")
      ->check(CLI::IsMember({"slam", "truth"}))
      ->capture_default_str();
  app.add_flag("--random-starts", arguments.random_starts, "begin elsewhere with each seed but 1");
  app.add_flag("--bound", arguments.bound, "write the least length of a way that sees all, too");
  app.add_option("--out", arguments.out, "folder for the tables and pictures")->required();
}

std::size_t unseenOf(const RunOutcome& run) {
  return static_cast<std::size_t>(
      std::count_if(run.contacts.begin(), run.contacts.end(),
                    [](const RunContact& contact) { return contact.unseen; }));
}

class Tables {
 public:
  explicit Tables(const std::filesystem::path& folder, const std::string& world)
      : runs_(folder / ("runs_" + world + ".csv"),
              "world,strategy,seed,elsewhere,ended,ending,time,distance,explored_time,explored_"
              "distance,"
              "coverage,from_home,collisions,unseen,goals,driving,turning,recovering,standing,"
              "explorer_cpu,"
              "navigator_cpu,area"),
        samples_(folder / ("coverage_" + world + ".csv"), "strategy,seed,time,distance,coverage"),
        paths_(folder / ("paths_" + world + ".csv"), "strategy,seed,x,y"),
        goals_(folder / ("goals_" + world + ".csv"), "strategy,seed,time,x,y,size,fate"),
        contacts_(folder / ("contacts_" + world + ".csv"), "strategy,seed,time,x,y,theta,unseen") {}

  void add(const std::string& world, const std::string& strategy, int seed, bool elsewhere,
           double area, const RunOutcome& run) {
    const auto number = static_cast<std::size_t>(seed);
    runs_.row(std::string_view(world), std::string_view(strategy), number,
              std::size_t{elsewhere ? 1U : 0U}, std::size_t{run.ended ? 1U : 0U},
              std::string_view(toString(run.ending)), run.end.time, run.end.distance,
              run.explored_time, run.explored_distance, run.end.coverage, run.from_home,
              run.contacts.size(), unseenOf(run), run.goals.size(), run.times.driving,
              run.times.turning, run.times.recovering, run.times.standing, run.explorer_cpu,
              run.navigator_cpu, area);
    for (const RunSample& sample : run.samples) {
      samples_.row(std::string_view(strategy), number, sample.time, sample.distance,
                   sample.coverage);
    }
    for (const RunGoal& goal : run.goals) {
      goals_.row(std::string_view(strategy), number, goal.time, goal.T_map_base.x,
                 goal.T_map_base.y, goal.size, std::string_view('"' + goal.fate + '"'));
    }
    for (const RunContact& contact : run.contacts) {
      contacts_.row(std::string_view(strategy), number, contact.time, contact.T_world_base.x,
                    contact.T_world_base.y, contact.T_world_base.theta,
                    std::size_t{contact.unseen ? 1U : 0U});
    }
    for (const Eigen::Vector2d& point : run.path) {
      paths_.row(std::string_view(strategy), number, point.x(), point.y());
    }
  }

 private:
  CsvFile runs_;
  CsvFile samples_;
  CsvFile paths_;
  CsvFile goals_;
  CsvFile contacts_;
};

void writeBound(const Arguments& arguments, const std::string& name, const Place& place,
                double radius, double range) {
  const WatchmanBound bound =
      watchmanBound(*place.world, place.T_world_start.translation(), radius, range);
  CsvFile table(std::filesystem::path(arguments.out) / ("bound_" + name + ".csv"),
                "world,length,witnesses");
  table.row(std::string_view(name), bound.length, bound.witnesses.size());
  CsvFile witnesses(std::filesystem::path(arguments.out) / ("witnesses_" + name + ".csv"), "x,y");
  for (const Eigen::Vector2d& witness : bound.witnesses) {
    witnesses.row(witness.x(), witness.y());
  }
}

void tell(const RunOutcome& outcome, const std::string& run) {
  fmt::print(
      "{}: {} {:.0f} s, {:.1f} m, {:.2f} % seen, home {:.2f} m, {} collisions, {} of them unseen. "
      "{}\n",
      run, toString(outcome.ending), outcome.end.time, outcome.end.distance,
      100.0 * outcome.end.coverage, outcome.from_home, outcome.contacts.size(), unseenOf(outcome),
      outcome.reason);
  std::fflush(stdout);
}

void run(const Arguments& arguments) {
  const Place place = loadPlace(arguments.world);
  const std::string name = arguments.name.empty()
                               ? std::filesystem::path(arguments.world).stem().stem().string()
                               : arguments.name;
  std::filesystem::create_directories(arguments.out);
  const navigation::Footprint footprint =
      navigation::readFootprint(arguments.urdf, "base_footprint");
  const double range = simulation::HokuyoConfig().range_max;
  const Seeable seeable(*place.world, place.T_world_start.translation(),
                        footprint.circumscribed_radius, range);
  if (arguments.bound) {
    writeBound(arguments, name, place, footprint.circumscribed_radius, range);
  }
  Tables tables(arguments.out, name);
  for (int seed = arguments.first_seed; seed < arguments.first_seed + arguments.seeds; ++seed) {
    for (const std::string& text : arguments.strategies) {
      const Share share = shareOf(text, arguments.seeds);
      if (seed >= arguments.first_seed + share.seeds) {
        continue;
      }
      RunSetup setup{place.world,       &seeable, place.T_world_start,
                     footprint,         {},       static_cast<std::uint64_t>(seed),
                     arguments.patience};
      setup.explorer.strategy = share.strategy;
      setup.explorer.seed = seed;
      setup.localisation =
          arguments.localisation == "truth" ? LocalisationKind::kTruth : LocalisationKind::kSlam;
      const bool elsewhere = arguments.random_starts && seed != 1;
      if (elsewhere) {
        setup.T_world_start = randomStart(place, footprint.circumscribed_radius, setup.seed);
      }
      const RunOutcome outcome = explore(setup);
      tables.add(name, share.strategy, seed, elsewhere, seeable.area(), outcome);
      tell(outcome, fmt::format("{} {} {}", name, share.strategy, seed));
      const std::string stem = fmt::format("{}_{}_{}", name, share.strategy, seed);
      (void)grid::saveMap(outcome.map, std::filesystem::path(arguments.out) / "maps" / stem);
    }
  }
}

}  // namespace
}  // namespace omega_slam::experiments

int main(int argc, char** argv) {
  CLI::App app(
      "Lets a simulated robot explore a world by each strategy and seed, and writes tables (CSV) "
      "and maps of all runs; scripts/experiments runs it for all worlds.");
  omega_slam::experiments::Arguments arguments;
  omega_slam::experiments::declare(app, arguments);
  return omega_slam::experiments::runProgram(app, argc, argv,
                                             [&] { omega_slam::experiments::run(arguments); });
}

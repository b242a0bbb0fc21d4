// How the navigator plans and drives. scripts/experiments runs it for each world.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "experiments/program.h"
#include "navigation/goals.h"
#include "navigation/queries.h"

namespace omega_slam::experiments {
namespace {

struct Arguments {
  std::string map;
  std::string urdf;
  std::string planner{"grid"};
  std::size_t queries{1000};
  GoalTrial trial;
};

void declare(CLI::App& app, Arguments& arguments) {
  app.require_subcommand(1);
  app.add_option("--map", arguments.map, "map_server's YAML file of the world")->required();
  app.add_option("--urdf", arguments.urdf, "the robot's description")->required();
  app.add_option("--seed", arguments.trial.seed)->capture_default_str();
  CLI::App* queries = app.add_subcommand("queries", "ways between random places");
  queries->add_option("--planner", arguments.planner)
      ->check(CLI::IsMember(navigation::plannerNames()))
      ->capture_default_str();
  queries->add_option("--count", arguments.queries)->capture_default_str();
  CLI::App* goals = app.add_subcommand("goals", "driving to goals among people");
  goals->add_option("--count", arguments.trial.goals)->capture_default_str();
  goals->add_option("--people", arguments.trial.people)->capture_default_str();
}

void printQueries(const Course& course, const Arguments& arguments) {
  fmt::print("world,planner,has_way,found,length,shortest,milliseconds,least_clearance,radius\n");
  for (const QueryResult& result :
       askForWays(course, arguments.planner, arguments.queries, arguments.trial.seed)) {
    fmt::print("{},{},{:d},{:d},{:.4f},{:.4f},{:.3f},{:.5f},{:.5f}\n", course.name,
               arguments.planner, result.has_way, result.found, result.length, result.shortest,
               result.milliseconds, result.least_clearance, course.footprint.circumscribed_radius);
  }
}

void printGoals(const Course& course, const Arguments& arguments) {
  fmt::print(
      "world,people,wanted,outcome,right,seconds,planned,driven,collisions,nearest_person\n");
  for (const GoalResult& result : driveToGoals(course, arguments.trial)) {
    fmt::print("{},{},\"{}\",\"{}\",{:d},{:.1f},{:.3f},{:.3f},{},{:.4f}\n", course.name,
               arguments.trial.people, result.wanted, result.outcome, result.right, result.seconds,
               result.planned, result.driven, result.collisions, result.nearest_person);
  }
}

}  // namespace
}  // namespace omega_slam::experiments

int main(int argc, char** argv) {
  using namespace omega_slam::experiments;
  CLI::App app("Plans and drives in a world; a table of all that came of it on stdout.");
  Arguments arguments;
  declare(app, arguments);
  return runProgram(app, argc, argv, [&] {
    const Course course = loadCourse(arguments.map, arguments.urdf);
    if (app.got_subcommand("queries")) {
      printQueries(course, arguments);
    } else {
      printGoals(course, arguments);
    }
  });
}

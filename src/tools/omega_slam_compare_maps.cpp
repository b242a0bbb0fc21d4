// How much two maps of the same building resemble each other.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "omega_slam/evaluation/comparison_picture.h"
#include "omega_slam/evaluation/feature_alignment.h"
#include "omega_slam/evaluation/map_correlation.h"
#include "omega_slam/evaluation/resemblance.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/map_file.h"

namespace omega_slam {
namespace {

constexpr int kBelow = 2;  // exit code: compared, but not alike enough

struct Arguments {
  std::string built;
  std::string truth;
  std::string align{"correlation"};
  std::vector<double> pose;
  std::vector<double> start;
  std::string plot;
  std::optional<double> at_least;
  evaluation::ResemblanceOptions options;
};

void declare(CLI::App& app, Arguments& arguments) {
  app.add_option("BUILT", arguments.built, "map to be judged (YAML of map_server)")->required();
  app.add_option("TRUTH", arguments.truth, "map that it is compared with, likewise")->required();
  app.add_option("--align", arguments.align,
                 "which alignment counts for --plot and --at-least: correlation always finds one; "
                 "sift is the paper's, by control points of the images; pose is the one given")
      ->check(CLI::IsMember({"correlation", "sift", "pose"}))
      ->capture_default_str();
  app.add_option("--pose", arguments.pose,
                 "X Y YAW [m m rad] of BUILT's frame in TRUTH's frame; 0 0 0: they share one frame")
      ->expected(3);
  app.add_option("--start", arguments.start,
                 "X Y [m] in TRUTH's frame: open space counts if it is connected with this point; "
                 "default: the largest open space")
      ->expected(2);
  app.add_option("--tolerance", arguments.options.wall_tolerance,
                 "a wall is in its place if one lies within so many cells")
      ->capture_default_str();
  app.add_option("--plot", arguments.plot, "picture of the differences (PNG)");
  app.add_option("--at-least", arguments.at_least,
                 "end with exit code 2 if the resemblance is less than this")
      ->check(CLI::Range(0.0, 1.0));
}

grid::OccupancyGrid load(const std::string& path) {
  return grid::toOccupancyGrid(grid::loadMapImage(path));
}

/// One way to lay the built map on the true one.
struct Alignment {
  std::string name;
  std::optional<geometry::Pose2> T_truth_map;
  std::string remark;  ///< for the user; if there is no alignment, why
};

std::vector<Alignment> alignAll(const Arguments& arguments, const grid::OccupancyGrid& built,
                                const grid::OccupancyGrid& truth) {
  std::vector<Alignment> all;
  if (const std::vector<double>& pose = arguments.pose; !pose.empty()) {
    all.push_back({"pose", geometry::Pose2{pose[0], pose[1], pose[2]}, ""});
  }
  const auto correlation = evaluation::alignByCorrelation(built, truth);
  all.push_back({"correlation",
                 correlation ? std::make_optional(correlation->T_truth_map) : std::nullopt,
                 correlation ? "" : "A map without walls can't be aligned."});
  const evaluation::FeatureAlignment features = evaluation::alignByFeatures(built, truth);
  all.push_back({"sift", features.T_truth_map,
                 features.T_truth_map ? fmt::format("{} and {} control points, {} pairs, of which "
                                                    "{} agree.",
                                                    features.built_points, features.truth_points,
                                                    features.matches, features.inliers)
                                      : features.reason});
  return all;
}

std::string percents(double precision, double recall) {
  return fmt::format("{:.2f} / {:.2f}", 100.0 * precision, 100.0 * recall);
}

void print(const Alignment& alignment, const evaluation::Resemblance& map) {
  const geometry::Pose2& pose = *alignment.T_truth_map;
  fmt::print("{:<12} {:>10.4f}  {:>8.4f}  {:>15}  {:>15}  {:>8.2f}  {:>8.3f} {:>8.3f} {:>8.2f}\n",
             alignment.name, map.score(), map.balanced(),
             percents(map.wallPrecision(), map.wallRecall()),
             percents(map.openPrecision(), map.openRecall()), 100.0 * map.coverage(), pose.x,
             pose.y, geometry::radiansToDegrees(pose.theta));
}

void printHead() {
  fmt::print("{:<12} {:>10}  {:>8}  {:>15}  {:>15}  {:>8}  {:>8} {:>8} {:>8}\n", "aligned by",
             "resemblance", "balanced", "walls p / r [%]", "open p / r [%]", "seen [%]", "x [m]",
             "y [m]", "yaw [deg]");
}

/// Compares at all alignments. @return what was found at the one that counts
std::optional<evaluation::MapComparison> compareAtAll(const Arguments& arguments,
                                                      const std::vector<Alignment>& alignments,
                                                      const grid::OccupancyGrid& built,
                                                      const grid::OccupancyGrid& truth) {
  std::optional<evaluation::MapComparison> counts;
  printHead();
  for (const Alignment& alignment : alignments) {
    if (!alignment.T_truth_map) {
      continue;
    }
    evaluation::MapPlacement placement{*alignment.T_truth_map, std::nullopt};
    if (!arguments.start.empty()) {
      placement.start_truth = Eigen::Vector2d(arguments.start[0], arguments.start[1]);
    }
    const auto comparison = evaluation::judgeMaps(built, truth, placement, arguments.options);
    print(alignment, comparison.resemblance);
    if (alignment.name == arguments.align) {
      counts = comparison;
    }
  }
  for (const Alignment& alignment : alignments) {
    if (!alignment.remark.empty()) {
      fmt::print("{}: {}\n", alignment.name, alignment.remark);
    }
  }
  return counts;
}

const Alignment& chosen(const Arguments& arguments, const std::vector<Alignment>& alignments) {
  for (const Alignment& alignment : alignments) {
    if (alignment.name == arguments.align) {
      return alignment;
    }
  }
  throw std::runtime_error("--align pose needs --pose.");
}

int run(const Arguments& arguments) {
  const grid::OccupancyGrid built = load(arguments.built);
  const grid::OccupancyGrid truth = load(arguments.truth);
  const std::vector<Alignment> alignments = alignAll(arguments, built, truth);
  const Alignment& alignment = chosen(arguments, alignments);
  const auto comparison = compareAtAll(arguments, alignments, built, truth);
  if (!comparison) {
    throw std::runtime_error(fmt::format("{} could not be laid on {} by {}. {}", arguments.built,
                                         arguments.truth, arguments.align, alignment.remark));
  }
  const double score = comparison->resemblance.score();
  if (!arguments.plot.empty()) {
    const std::string fault = evaluation::writeComparisonPicture(
        arguments.plot,
        {built, truth, *alignment.T_truth_map, *comparison,
         fmt::format("resemblance {:.2f} %, aligned by {}", 100.0 * score, alignment.name)});
    if (!fault.empty()) {
      throw std::runtime_error(fault);
    }
  }
  if (arguments.at_least && score < *arguments.at_least) {
    fmt::print(stderr, "omega_slam_compare_maps: the resemblance is {:.4f}, below {}.\n", score,
               *arguments.at_least);
    return kBelow;
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  CLI::App app(
      "Lays a built map on the true one and compares them cell by cell: each built wall and each "
      "built open cell is right or wrong, and the resemblance is the share that is right.");
  omega_slam::Arguments arguments;
  omega_slam::declare(app, arguments);
  CLI11_PARSE(app, argc, argv);
  try {
    return omega_slam::run(arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "omega_slam_compare_maps: {}\n", error.what());
    return EXIT_FAILURE;
  }
}

#include "maps/map_scores.h"

#include <fmt/format.h>

#include <stdexcept>

#include "experiments/csv_file.h"
#include "omega_slam/evaluation/comparison_picture.h"
#include "omega_slam/evaluation/feature_alignment.h"
#include "omega_slam/evaluation/map_correlation.h"
#include "omega_slam/evaluation/map_picture.h"

namespace omega_slam::experiments {
namespace {

using evaluation::Resemblance;
using geometry::Pose2;
using grid::OccupancyGrid;

struct Alignment {
  std::string name;
  std::optional<Pose2> T_truth_map;
};

void throwIfFailed(const std::string& failure) {
  if (!failure.empty()) {
    throw std::runtime_error(failure);
  }
}

std::vector<Alignment> alignments(const OccupancyGrid& map, const Site& site,
                                  const Pose2& by_trajectory) {
  const auto correlation = evaluation::alignByCorrelation(map, site.truth);
  return {
      {"trajectory", by_trajectory},
      {"sift", evaluation::alignByFeatures(map, site.truth).T_truth_map},
      {"correlation", correlation ? std::make_optional(correlation->T_truth_map) : std::nullopt}};
}

class ScoreTable {
 public:
  ScoreTable(const std::filesystem::path& path, const Site& site, std::uint64_t seed)
      : file_(path,
              "site,seed,renderer,source,alignment,aligned,score,balanced,wall_precision,"
              "wall_recall,open_precision,open_recall,coverage"),
        site_(site),
        seed_(seed) {}

  void add(const std::string& renderer, const std::string& source, const OccupancyGrid& map,
           const Pose2& T_truth_map) {
    for (const Alignment& alignment : alignments(map, site_, T_truth_map)) {
      Resemblance found;
      if (alignment.T_truth_map) {
        found = evaluation::compareMaps(
            map, site_.truth, {*alignment.T_truth_map, site_.world.file.start.translation()});
      }
      file_.row(site_.name, std::size_t{seed_}, renderer, source, alignment.name,
                std::size_t{alignment.T_truth_map ? 1U : 0U}, found.score(), found.balanced(),
                found.wallPrecision(), found.wallRecall(), found.openPrecision(),
                found.openRecall(), found.coverage());
    }
  }

 private:
  CsvFile file_;
  const Site& site_;
  std::uint64_t seed_;
};

/// SLAM's map beside the truth, and on it.
void drawPictures(const Site& site, const std::string& renderer, const OccupancyGrid& map,
                  const Pose2& T_truth_map, const std::filesystem::path& folder) {
  const std::string stem = fmt::format("{}_{}", site.name, renderer);
  throwIfFailed(
      evaluation::writeMapPicture(folder / (stem + ".png"), {map, {}, {}, "drawn by " + renderer}));
  const auto comparison =
      evaluation::judgeMaps(map, site.truth, {T_truth_map, site.world.file.start.translation()});
  throwIfFailed(
      evaluation::writeComparisonPicture(folder / (stem + "_differences.png"),
                                         {map, site.truth, T_truth_map, comparison,
                                          fmt::format("drawn by {}, resemblance {:.2f} %", renderer,
                                                      100.0 * comparison.resemblance.score())}));
}

void drawTruth(const Site& site, const std::filesystem::path& folder) {
  evaluation::MapPicture picture{site.truth, {}, {}, "the truth, and the way of the robot"};
  for (const Eigen::Vector2d& waypoint : site.world.file.route) {
    picture.true_path.push_back({0.0, {waypoint.x(), waypoint.y(), 0.0}});
  }
  throwIfFailed(evaluation::writeMapPicture(folder / (site.name + "_truth.png"), picture));
}

}  // namespace

std::vector<NamedRenderer> renderers() {
  NamedRenderer triangle{"triangle", {}};
  triangle.config.kind = mapping::RendererKind::kTriangle;
  NamedRenderer plain = triangle;
  plain.name = "plain_triangle";
  plain.config.triangle.join_all = true;
  return {{"beam", {}}, triangle, plain};
}

OccupancyGrid drawMap(const std::vector<PlacedSweep>& sweeps,
                      const mapping::RendererConfig& renderer, bool forget_people) {
  mapping::OccupancyMapperConfig config;
  config.forget_people = forget_people;
  config.renderer = renderer;
  mapping::OccupancyMapper mapper(config);
  for (const PlacedSweep& placed : sweeps) {
    throwIfFailed(mapper.add(placed.sweep, placed.T_map_base));
  }
  return mapper.render();
}

void runSurvey(const Site& site, std::uint64_t seed, const SurveyOutput& output) {
  const Survey done = survey(site, seed);
  const std::string key = fmt::format("{}_{}.csv", site.name, seed);
  CsvFile(output.folder / ("surveys_" + key),
          "site,seed,seconds,metres,scans,keyframes,loops,seen_from_route,mean_error,max_error")
      .row(site.name, std::size_t{seed}, done.duration, done.distance, done.scans,
           done.by_slam.size(), done.loops, site.seen_from_route, done.error.translation.mean,
           done.error.translation.max);
  ScoreTable table(output.folder / ("scores_" + key), site, seed);
  for (const NamedRenderer& renderer : renderers()) {
    const OccupancyGrid map = drawMap(done.by_slam, renderer.config);
    table.add(renderer.name, "slam", map, done.error.T_truth_map);
    table.add(renderer.name, "true_poses", drawMap(done.by_truth, renderer.config), {});
    table.add(renderer.name, "no_noise", drawMap(done.without_noise, renderer.config), {});
    if (output.pictures) {
      drawPictures(site, renderer.name, map, done.error.T_truth_map, output.folder);
    }
  }
  if (output.pictures) {
    drawTruth(site, output.folder);
  }
}

}  // namespace omega_slam::experiments

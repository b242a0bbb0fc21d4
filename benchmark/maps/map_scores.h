#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "maps/survey.h"
#include "omega_slam/evaluation/resemblance.h"
#include "omega_slam/mapping/occupancy_mapper.h"

namespace omega_slam::experiments {

/// The renderers that are compared, with the names that tables have for them.
struct NamedRenderer {
  std::string name;
  mapping::RendererConfig config;
};
[[nodiscard]] std::vector<NamedRenderer> renderers();

/// Draws the sweeps by the default mapper with this renderer.
[[nodiscard]] grid::OccupancyGrid drawMap(const std::vector<PlacedSweep>& sweeps,
                                          const mapping::RendererConfig& renderer,
                                          bool forget_people = true);

/// Where to put what an experiment finds.
struct SurveyOutput {
  std::filesystem::path folder;
  bool pictures{false};
};

/// Surveys a site, draws its map by each renderer, from SLAM and from the truth with and without
/// noise, lays each on the true map in each way, and writes
///
/// * `surveys_<site>_<seed>.csv`: the drive and the error of SLAM
/// * `scores_<site>_<seed>.csv`: a row for each map and alignment
/// * `<site>_<renderer>.png` and `<site>_<renderer>_differences.png`, if asked for: SLAM's maps;
/// and
///   `<site>_truth.png` with the robot's path
void runSurvey(const Site& site, std::uint64_t seed, const SurveyOutput& output);

}  // namespace omega_slam::experiments

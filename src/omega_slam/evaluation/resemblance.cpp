#include "omega_slam/evaluation/resemblance.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "omega_slam/evaluation/cell_mask.h"

namespace omega_slam::evaluation {
namespace {

using grid::Cell;
using grid::OccupancyGrid;

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::size_t count(const std::vector<Verdict>& verdicts, Verdict wanted) {
  return static_cast<std::size_t>(std::count(verdicts.begin(), verdicts.end(), wanted));
}

/// What was built, looked up in the truth.
std::vector<Verdict> judgeBuilt(const OccupancyGrid& built, const geometry::Pose2& T_truth_map,
                                const CellMask& true_walls, const CellMask& true_open) {
  std::vector<Verdict> verdicts(built.cells.size(), Verdict::kNone);
  forEachCell(built.geometry, [&](const Cell& cell) {
    const std::int8_t value = built.at(cell);
    const Eigen::Vector2d p_truth = T_truth_map * built.geometry.center(cell);
    Verdict& verdict = verdicts[built.geometry.index(cell)];
    if (isWall(value)) {
      verdict = true_walls.at(p_truth) ? Verdict::kWallRight : Verdict::kWallWrong;
    } else if (isOpen(value)) {
      verdict = true_open.at(p_truth) ? Verdict::kOpenRight : Verdict::kOpenWrong;
    }
  });
  return verdicts;
}

/// What there was to be found, looked up in what was built.
std::vector<Verdict> judgeTruth(const OccupancyGrid& truth, const geometry::Pose2& T_map_truth,
                                const CellMask& true_open, const OccupancyGrid& built,
                                int wall_tolerance) {
  const CellMask built_open = openCells(built);
  const CellMask built_walls = wallsWidened(built, 0);
  const CellMask walls_nearby = wallsWidened(built, wall_tolerance);
  std::vector<Verdict> verdicts(truth.cells.size(), Verdict::kNone);
  forEachCell(truth.geometry, [&](const Cell& cell) {
    const Eigen::Vector2d p_map = T_map_truth * truth.geometry.center(cell);
    Verdict& verdict = verdicts[truth.geometry.index(cell)];
    if (true_open.at(cell)) {
      verdict = built_open.at(p_map)    ? Verdict::kOpenRight
                : built_walls.at(p_map) ? Verdict::kOpenMissed
                                        : Verdict::kOpenUnseen;
    } else if (isWall(truth.at(cell)) && true_open.touches(cell)) {
      verdict = walls_nearby.at(p_map) ? Verdict::kWallRight : Verdict::kWallMissed;
    }
  });
  return verdicts;
}

Resemblance sum(const std::vector<Verdict>& built, const std::vector<Verdict>& truth) {
  Resemblance result;
  result.walls_right = count(built, Verdict::kWallRight);
  result.walls_wrong = count(built, Verdict::kWallWrong);
  result.open_right = count(built, Verdict::kOpenRight);
  result.open_wrong = count(built, Verdict::kOpenWrong);
  result.walls_found = count(truth, Verdict::kWallRight);
  result.walls_to_find = result.walls_found + count(truth, Verdict::kWallMissed);
  result.open_found = count(truth, Verdict::kOpenRight);
  result.open_seen = result.open_found + count(truth, Verdict::kOpenMissed);
  result.open_to_find = result.open_seen + count(truth, Verdict::kOpenUnseen);
  return result;
}

}  // namespace

double Resemblance::score() const {
  const std::size_t right = walls_right + open_right;
  return share(right, right + walls_wrong + open_wrong);
}
double Resemblance::balanced() const { return 0.5 * (wallPrecision() + openPrecision()); }
double Resemblance::wallPrecision() const { return share(walls_right, walls_right + walls_wrong); }
double Resemblance::wallRecall() const { return share(walls_found, walls_to_find); }
double Resemblance::openPrecision() const { return share(open_right, open_right + open_wrong); }
double Resemblance::openRecall() const { return share(open_found, open_to_find); }
double Resemblance::coverage() const { return share(open_seen, open_to_find); }

std::vector<std::string> ResemblanceOptions::validate() const {
  constexpr int kMost = 100;
  if (wall_tolerance >= 0 && wall_tolerance <= kMost) {
    return {};
  }
  return {fmt::format("wall_tolerance must be from 0 to {} cells, but it is {}.", kMost,
                      wall_tolerance)};
}

MapComparison judgeMaps(const OccupancyGrid& built, const OccupancyGrid& truth,
                        const MapPlacement& placement, const ResemblanceOptions& options) {
  if (const std::vector<std::string> faults = options.validate(); !faults.empty()) {
    throw std::invalid_argument(fmt::format("{}", fmt::join(faults, " ")));
  }
  const CellMask true_open = placement.start_truth ? reachableFrom(truth, *placement.start_truth)
                                                   : largestOpenSpace(truth);
  MapComparison comparison;
  comparison.built = judgeBuilt(built, placement.T_truth_map,
                                wallsWidened(truth, options.wall_tolerance), true_open);
  comparison.truth =
      judgeTruth(truth, placement.T_truth_map.inverse(), true_open, built, options.wall_tolerance);
  comparison.resemblance = sum(comparison.built, comparison.truth);
  return comparison;
}

}  // namespace omega_slam::evaluation

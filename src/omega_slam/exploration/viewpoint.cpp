#include "omega_slam/exploration/viewpoint.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/grid/ray_traversal.h"

namespace omega_slam::exploration {
namespace {

constexpr double kTriedRadius = 0.3;  // [m] a place nearer to one that was tried is the same

/// A place of a search, and the frontier cell that it comes from.
struct Step {
  Cell cell;
  Cell source;
  int steps{0};
};

bool isTried(const Eigen::Vector2d& place, const std::vector<Eigen::Vector2d>& tried) {
  return std::any_of(tried.begin(), tried.end(), [&place](const Eigen::Vector2d& other) {
    return (place - other).norm() < kTriedRadius;
  });
}

std::vector<Step> nearCentroidFirst(const Frontier& frontier, const MapView& map) {
  std::vector<Step> steps;
  for (const Cell& cell : frontier.cells) {
    steps.push_back({cell, cell, 0});
  }
  const Cell middle = map.cellAt(frontier.centroid);
  std::stable_sort(steps.begin(), steps.end(), [&middle](const Step& a, const Step& b) {
    return (a.cell - middle).squaredNorm() < (b.cell - middle).squaredNorm();
  });
  return steps;
}

Viewpoint lookingAt(const Frontier& frontier, const Eigen::Vector2d& place, double travel) {
  const Eigen::Vector2d towards = frontier.centroid - place;
  return {{place.x(), place.y(), std::atan2(towards.y(), towards.x())}, travel};
}

}  // namespace

bool isInSight(const MapView& map, const Cell& from, const Cell& to) {
  const Eigen::Vector2d half(0.5, 0.5);
  bool clear = true;
  grid::traverseCells(from.cast<double>() + half, to.cast<double>() + half,
                      [&](const Cell& cell) { clear = clear && (cell == to || map.isFree(cell)); });
  return clear;
}

std::optional<Viewpoint> findViewpoint(const Frontier& frontier, const MapView& map,
                                       const TravelField& travel,
                                       const std::vector<Eigen::Vector2d>& tried, double reach) {
  const int max_steps = static_cast<int>(reach / map.geometry().resolution);
  std::vector<Step> queue = nearCentroidFirst(frontier, map);
  CellSet met(frontier.cells.begin(), frontier.cells.end());
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Step here = queue[i];
    const auto distance = travel.distanceTo(here.cell);
    const Eigen::Vector2d place = map.center(here.cell);
    if (distance && !isTried(place, tried) && isInSight(map, here.cell, here.source)) {
      return lookingAt(frontier, place, *distance);
    }
    for (std::size_t k = 0; k < kEdgeNeighbours && here.steps < max_steps; ++k) {
      const Cell next = here.cell + kNeighbours[k];
      if (map.isFree(next) && met.insert(next).second) {
        queue.push_back({next, here.source, here.steps + 1});
      }
    }
  }
  return std::nullopt;
}

}  // namespace omega_slam::exploration

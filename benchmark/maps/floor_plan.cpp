#include "maps/floor_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <queue>
#include <stdexcept>
#include <utility>

#include "omega_slam/evaluation/cell_mask.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/ray_traversal.h"

namespace omega_slam::experiments {

using grid::Cell;

namespace {

constexpr double kComfortable = 0.6;  // [m] more room than this is worth no detour
constexpr double kNarrowness = 4.0;   // metres that a metre without any room is worth
constexpr double kNowhere = std::numeric_limits<double>::infinity();

}  // namespace

FloorPlan::FloorPlan(grid::OccupancyGrid map, double room) : map_(std::move(map)), room_(room) {
  // A rim of walls: outside is nowhere to be.
  cv::Mat open(map_.geometry.height + 2, map_.geometry.width + 2, CV_8UC1, cv::Scalar(0));
  evaluation::forEachCell(map_.geometry, [&](const Cell& cell) {
    open.at<std::uint8_t>(cell.y() + 1, cell.x() + 1) = evaluation::isOpen(map_.at(cell)) ? 1 : 0;
  });
  cv::Mat distances;
  cv::distanceTransform(open, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  clearance_.resize(map_.geometry.size());
  evaluation::forEachCell(map_.geometry, [&](const Cell& cell) {
    const double cells = distances.at<float>(cell.y() + 1, cell.x() + 1) - 0.5;
    clearance_[map_.geometry.index(cell)] =
        static_cast<float>(map_.geometry.resolution * std::max(0.0, cells));
  });
}

double FloorPlan::clearance(const Cell& cell) const {
  return geometry().contains(cell) ? static_cast<double>(clearance_[geometry().index(cell)]) : 0.0;
}

Cell FloorPlan::nearestFit(const Eigen::Vector2d& point) const {
  double least = kNowhere;
  Cell nearest(-1, -1);
  evaluation::forEachCell(geometry(), [&](const Cell& cell) {
    const double distance = (geometry().center(cell) - point).norm();
    if (fits(cell) && distance < least) {
      least = distance;
      nearest = cell;
    }
  });
  if (!std::isfinite(least)) {
    throw std::runtime_error("The robot fits nowhere in this map.");
  }
  return nearest;
}

double FloorPlan::clearanceAlong(const Cell& from, const Cell& to) const {
  double least = kNowhere;
  grid::traverseRay(geometry(), geometry().center(from), geometry().center(to),
                    [&](const Cell& cell) { least = std::min(least, clearance(cell)); });
  return least;
}

std::vector<std::size_t> FloorPlan::visibleFrom(const Cell& cell, double range, double heading,
                                                double half_angle) const {
  std::vector<std::size_t> seen;
  const Eigen::Vector2d eye = geometry().center(cell);
  const double step = geometry().resolution / range;
  const int rays = static_cast<int>(std::ceil(half_angle / step));
  for (int k = -rays; k <= rays; ++k) {
    const double angle = heading + half_angle * k / rays;
    const Eigen::Vector2d end = eye + range * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    bool blocked = false;
    grid::traverseRay(geometry(), eye, end, [&](const Cell& passed) {
      blocked = blocked || !geometry().contains(passed) || !evaluation::isOpen(map_.at(passed));
      if (!blocked) {
        seen.push_back(geometry().index(passed));
      }
    });
  }
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  return seen;
}

Ways::Ways(const FloorPlan& plan, const Cell& from)
    : plan_(plan),
      costs_(plan.geometry().size(), kNowhere),
      parents_(plan.geometry().size(), plan.geometry().index(from)) {
  const grid::GridGeometry& geometry = plan.geometry();
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  costs_[geometry.index(from)] = 0.0;
  queue.emplace(0.0, geometry.index(from));
  while (!queue.empty()) {
    const auto [cost, index] = queue.top();
    queue.pop();
    if (cost > costs_[index]) {
      continue;
    }
    const auto width = static_cast<std::size_t>(geometry.width);
    const Cell cell(static_cast<int>(index % width), static_cast<int>(index / width));
    for (const Cell& step :
         std::array<Cell, 8>{Cell(1, 0), Cell(0, 1), Cell(-1, 0), Cell(0, -1), Cell(1, 1),
                             Cell(-1, 1), Cell(-1, -1), Cell(1, -1)}) {
      const Cell next = cell + step;
      if (!plan.fits(next)) {
        continue;
      }
      const double narrow = std::max(0.0, 1.0 - plan.clearance(next) / kComfortable);
      const double reached =
          cost + step.cast<double>().norm() * geometry.resolution * (1.0 + kNarrowness * narrow);
      if (reached < costs_[geometry.index(next)]) {
        costs_[geometry.index(next)] = reached;
        parents_[geometry.index(next)] = index;
        queue.emplace(reached, geometry.index(next));
      }
    }
  }
}

std::optional<double> Ways::cost(const Cell& to) const {
  const double cost = costs_[plan_.geometry().index(to)];
  return std::isfinite(cost) ? std::make_optional(cost) : std::nullopt;
}

std::vector<Cell> Ways::path(const Cell& to) const {
  const auto width = static_cast<std::size_t>(plan_.geometry().width);
  std::vector<Cell> cells;
  std::size_t index = plan_.geometry().index(to);
  while (true) {
    cells.emplace_back(static_cast<int>(index % width), static_cast<int>(index / width));
    if (costs_[index] == 0.0) {
      break;
    }
    index = parents_[index];
  }
  std::reverse(cells.begin(), cells.end());
  return cells;
}

}  // namespace omega_slam::experiments

#include "omega_slam/navigation/grid_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <utility>

namespace omega_slam::navigation {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kAbout = 2;       // [cells] to where a point may be joined to the grid
constexpr float kHurry = 4.0F;  // by so much what is left outweighs what is done, in a hurry

struct Step {
  int column;
  int row;
};
constexpr std::array<Step, 8> kSteps{Step{1, 0},  Step{1, 1},   Step{0, 1},  Step{-1, 1},
                                     Step{-1, 0}, Step{-1, -1}, Step{0, -1}, Step{1, -1}};
constexpr std::uint8_t kNoStep = 255;

/// The shortest way over an empty grid [cells].
double octileDistance(const grid::Cell& a, const grid::Cell& b) {
  const Eigen::Array2i way = (a - b).cwiseAbs();
  return way.maxCoeff() + (std::sqrt(2.0) - 1.0) * way.minCoeff();
}

grid::Cell cellOf(const grid::GridGeometry& geometry, std::size_t index) {
  const auto width = static_cast<std::size_t>(geometry.width);
  return {static_cast<int>(index % width), static_cast<int>(index / width)};
}

}  // namespace

/// What a search knows of each cell.
struct GridSearch::Field {
  struct Entry {
    float estimate;
    std::uint32_t index;
    /// Last comes the least; among equals the one with the lower index, so that runs repeat.
    [[nodiscard]] bool operator<(const Entry& other) const {
      return estimate != other.estimate ? estimate > other.estimate : index > other.index;
    }
  };

  std::vector<float> costs;
  std::vector<std::uint8_t> arrivals;  ///< by which step a cell is reached
  std::vector<float> rates;            ///< cost of a metre at its centre; 0: not looked up yet
  std::priority_queue<Entry> open;
  grid::Cell goal;
  float weight{1.0F};  ///< of what is left

  [[nodiscard]] float heuristic(const grid::Cell& cell, double resolution) const {
    return weight * static_cast<float>(resolution * octileDistance(cell, goal));
  }
};

GridSearch::GridSearch(const Costmap& costmap, const ClearanceCost& cost, std::size_t max_looked)
    : costmap_(costmap),
      cost_(cost),
      max_looked_(max_looked),
      room_(std::hypot(cost.radius, 0.5 * std::sqrt(2.0) * costmap.geometry().resolution)) {}

bool GridSearch::isPassable(const grid::Cell& cell) const {
  return costmap_.geometry().contains(cell) && costmap_.isFree(cell, room_);
}

std::vector<grid::Cell> GridSearch::cellsAbout(const Eigen::Vector2d& point) const {
  const grid::GridGeometry& geometry = costmap_.geometry();
  const grid::Cell middle = geometry.cellAt(point);
  std::vector<grid::Cell> cells;
  for (int row = -kAbout; row <= kAbout; ++row) {
    for (int column = -kAbout; column <= kAbout; ++column) {
      const grid::Cell cell = middle + grid::Cell(column, row);
      if (isPassable(cell) && costmap_.isFree(point, geometry.center(cell), cost_.radius)) {
        cells.push_back(cell);
      }
    }
  }
  return cells;
}

std::optional<GridSearch::Field> GridSearch::fieldTowards(const Eigen::Vector2d& to) const {
  const grid::GridGeometry& geometry = costmap_.geometry();
  const std::vector<grid::Cell> ends = cellsAbout(to);
  if (ends.empty()) {
    return std::nullopt;
  }
  Field field;
  field.costs.assign(geometry.size(), kInfinity);
  field.arrivals.assign(geometry.size(), kNoStep);
  field.rates.assign(geometry.size(), 0.0F);
  // The nearest of the cells about the goal stands for all.
  field.goal = *std::min_element(ends.begin(), ends.end(), [&](const auto& a, const auto& b) {
    return (geometry.center(a) - to).norm() < (geometry.center(b) - to).norm();
  });
  return field;
}

void GridSearch::open(Field& field, const grid::Cell& cell, double cost) const {
  const grid::GridGeometry& geometry = costmap_.geometry();
  const std::size_t index = geometry.index(cell);
  if (const auto least = static_cast<float>(cost); least < field.costs[index]) {
    field.costs[index] = least;
    field.open.push(
        {least + field.heuristic(cell, geometry.resolution), static_cast<std::uint32_t>(index)});
  }
}

void GridSearch::expand(Field& field, std::size_t index) const {
  const grid::GridGeometry& geometry = costmap_.geometry();
  const grid::Cell cell = cellOf(geometry, index);
  const auto rateAt = [&](const grid::Cell& at) {
    float& rate = field.rates[geometry.index(at)];
    if (rate == 0.0F) {
      rate = isPassable(at)
                 ? static_cast<float>(cost_.perMetre(costmap_.clearance(geometry.center(at))))
                 : kInfinity;
    }
    return rate;
  };
  const float rate = rateAt(cell);
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    const grid::Cell next = cell + grid::Cell(kSteps[i].column, kSteps[i].row);
    if (!geometry.contains(next) || rateAt(next) == kInfinity) {
      continue;
    }
    const auto length =
        static_cast<float>(geometry.resolution * std::hypot(kSteps[i].column, kSteps[i].row));
    const float cost = field.costs[index] + 0.5F * (rate + rateAt(next)) * length;
    const std::size_t next_index = geometry.index(next);
    if (cost < field.costs[next_index]) {
      field.costs[next_index] = cost;
      field.arrivals[next_index] = static_cast<std::uint8_t>(i);
      field.open.push({cost + field.heuristic(next, geometry.resolution),
                       static_cast<std::uint32_t>(next_index)});
    }
  }
}

SearchOutcome GridSearch::find(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  const grid::GridGeometry& geometry = costmap_.geometry();
  if ((to - from).norm() < geometry.resolution && costmap_.isFree(from, to, cost_.radius)) {
    return {Path{from, to}, cost_.ofLine(costmap_, from, to)};
  }
  auto field = fieldTowards(to);
  if (!field) {
    return {};
  }
  for (const grid::Cell& cell : cellsAbout(from)) {
    open(*field, cell, cost_.ofLine(costmap_, from, geometry.center(cell)));
  }
  SearchOutcome outcome = run(*field, to);
  if (outcome.path) {
    outcome.path->insert(outcome.path->begin(), from);
  }
  return outcome;
}

SearchOutcome GridSearch::findFromAny(const std::vector<Departure>& departures,
                                      const Eigen::Vector2d& to) const {
  auto field = fieldTowards(to);
  if (!field) {
    return {};
  }
  for (const Departure& departure : departures) {
    open(*field, costmap_.geometry().cellAt(departure.point), departure.cost);
  }
  return run(*field, to);
}

SearchOutcome GridSearch::run(Field& field, const Eigen::Vector2d& to) const {
  const grid::GridGeometry& geometry = costmap_.geometry();
  SearchOutcome outcome;
  while (!field.open.empty()) {
    const auto entry = field.open.top();
    const grid::Cell cell = cellOf(geometry, entry.index);
    if (cell == field.goal) {
      outcome.path = trace(field, cell);
      outcome.path->push_back(to);
      outcome.cost = field.costs[entry.index] + cost_.ofLine(costmap_, geometry.center(cell), to);
      return outcome;
    }
    if (outcome.looked == max_looked_) {
      outcome.is_spent = true;
      return outcome;
    }
    field.open.pop();
    // An entry that is too high was overtaken by a cheaper way to its cell.
    if (entry.estimate <= field.costs[entry.index] + field.heuristic(cell, geometry.resolution)) {
      expand(field, entry.index);
      if (++outcome.looked == max_looked_ / 2) {
        hurry(field);
      }
    }
  }
  return outcome;
}

void GridSearch::hurry(Field& field) const {
  const grid::GridGeometry& geometry = costmap_.geometry();
  field.weight = kHurry;
  std::priority_queue<Field::Entry> open;
  for (; !field.open.empty(); field.open.pop()) {
    const std::uint32_t index = field.open.top().index;
    open.push({field.costs[index] + field.heuristic(cellOf(geometry, index), geometry.resolution),
               index});
  }
  field.open = std::move(open);
}

Path GridSearch::trace(const Field& field, grid::Cell cell) const {
  const grid::GridGeometry& geometry = costmap_.geometry();
  Path path{geometry.center(cell)};
  for (std::uint8_t arrival = field.arrivals[geometry.index(cell)]; arrival != kNoStep;
       arrival = field.arrivals[geometry.index(cell)]) {
    cell -= grid::Cell(kSteps[arrival].column, kSteps[arrival].row);
    path.push_back(geometry.center(cell));
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace omega_slam::navigation

#include "omega_slam/evaluation/resemblance.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace omega_slam::evaluation {
namespace {

using grid::Cell;
using grid::GridGeometry;
using grid::OccupancyGrid;

bool isWall(std::int8_t value) { return value >= 65; }
bool isOpen(std::int8_t value) { return value >= 0 && value <= 25; }

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// One yes or no for each cell of a grid; outside of it the answer is no.
class Mask {
 public:
  explicit Mask(const GridGeometry& geometry) : geometry_(geometry), flags_(geometry.size(), 0) {}

  void set(const Cell& cell) {
    if (geometry_.contains(cell)) {
      flags_[geometry_.index(cell)] = 1;
    }
  }
  [[nodiscard]] bool at(const Cell& cell) const {
    return geometry_.contains(cell) && flags_[geometry_.index(cell)] != 0;
  }
  [[nodiscard]] bool at(const Eigen::Vector2d& point) const {
    // Points far outside would not fit into a cell's numbers.
    const Eigen::Array2d cells = (point - geometry_.origin).array() / geometry_.resolution;
    const bool inside =
        (cells >= 0.0).all() && cells.x() < geometry_.width && cells.y() < geometry_.height;
    return inside && at(Cell(cells.floor().cast<int>()));
  }

 private:
  GridGeometry geometry_;
  std::vector<std::uint8_t> flags_;
};

template <typename Visitor>
void forEachCell(const GridGeometry& geometry, Visitor&& visit) {
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      visit(Cell(x, y));
    }
  }
}

/// Walls and what lies within so many cells of one.
Mask wallsWidened(const OccupancyGrid& map, int reach) {
  Mask mask(map.geometry);
  forEachCell(map.geometry, [&](const Cell& cell) {
    if (!isWall(map.at(cell))) {
      return;
    }
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        mask.set(cell + Cell(dx, dy));
      }
    }
  });
  return mask;
}

/// Open cells that are connected with the start, by edges of cells.
Mask reachable(const OccupancyGrid& map, const Eigen::Vector2d& start) {
  Mask open(map.geometry);
  forEachCell(map.geometry, [&](const Cell& cell) {
    if (isOpen(map.at(cell))) {
      open.set(cell);
    }
  });
  Mask reached(map.geometry);
  if (!open.at(start)) {
    return reached;
  }
  std::vector<Cell> pending{map.geometry.cellAt(start)};
  reached.set(pending.front());
  const std::array<Cell, 4> steps{Cell(1, 0), Cell(0, 1), Cell(-1, 0), Cell(0, -1)};
  while (!pending.empty()) {
    const Cell cell = pending.back();
    pending.pop_back();
    for (const Cell& step : steps) {
      if (const Cell next = cell + step; open.at(next) && !reached.at(next)) {
        reached.set(next);
        pending.push_back(next);
      }
    }
  }
  return reached;
}

bool touches(const Mask& mask, const Cell& cell) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (mask.at(Cell(cell + Cell(dx, dy)))) {
        return true;
      }
    }
  }
  return false;
}

/// What was built, looked up in the truth.
void judgeBuilt(const OccupancyGrid& built, const geometry::Pose2& T_truth_map,
                const Mask& true_walls, const Mask& true_open, Resemblance& result) {
  forEachCell(built.geometry, [&](const Cell& cell) {
    const std::int8_t value = built.at(cell);
    const Eigen::Vector2d p_truth = T_truth_map * built.geometry.center(cell);
    if (isWall(value)) {
      ++(true_walls.at(p_truth) ? result.walls_right : result.walls_wrong);
    } else if (isOpen(value)) {
      ++(true_open.at(p_truth) ? result.open_right : result.open_wrong);
    }
  });
}

/// What there was to be found, looked up in what was built.
void judgeFound(const OccupancyGrid& truth, const geometry::Pose2& T_map_truth,
                const Mask& true_open, const OccupancyGrid& built, const Mask& built_walls,
                Resemblance& result) {
  Mask built_open(built.geometry);
  Mask built_known(built.geometry);
  forEachCell(built.geometry, [&](const Cell& cell) {
    const std::int8_t value = built.at(cell);
    if (isOpen(value)) {
      built_open.set(cell);
    }
    if (isOpen(value) || isWall(value)) {
      built_known.set(cell);
    }
  });
  forEachCell(truth.geometry, [&](const Cell& cell) {
    const Eigen::Vector2d p_map = T_map_truth * truth.geometry.center(cell);
    if (true_open.at(cell)) {
      ++result.open_to_find;
      result.open_found += built_open.at(p_map) ? 1U : 0U;
      result.open_seen += built_known.at(p_map) ? 1U : 0U;
    } else if (isWall(truth.at(cell)) && touches(true_open, cell)) {
      ++result.walls_to_find;
      result.walls_found += built_walls.at(p_map) ? 1U : 0U;
    }
  });
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

Resemblance compareMaps(const OccupancyGrid& built, const OccupancyGrid& truth,
                        const MapPlacement& placement, const ResemblanceOptions& options) {
  if (const std::vector<std::string> faults = options.validate(); !faults.empty()) {
    throw std::invalid_argument(fmt::format("{}", fmt::join(faults, " ")));
  }
  const Mask true_walls = wallsWidened(truth, options.wall_tolerance);
  const Mask true_open = reachable(truth, placement.start_truth);
  Resemblance result;
  judgeBuilt(built, placement.T_truth_map, true_walls, true_open, result);
  judgeFound(truth, placement.T_truth_map.inverse(), true_open, built,
             wallsWidened(built, options.wall_tolerance), result);
  return result;
}

}  // namespace omega_slam::evaluation

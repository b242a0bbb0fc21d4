#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "omega_slam/navigation/costmap.h"
#include "omega_slam/navigation/path.h"

namespace omega_slam::navigation {

/// Costs of the cheapest ways from one place to all cells of a map.
struct TravelCosts {
  grid::GridGeometry geometry;
  std::vector<float> costs;  ///< row-major; infinite where the robot cannot get to

  /// To the cell of a point; infinite outside of the map.
  [[nodiscard]] double to(const Eigen::Vector2d& point) const {
    const grid::Cell cell = geometry.cellAt(point);
    return geometry.contains(cell) ? static_cast<double>(costs[geometry.index(cell)])
                                   : std::numeric_limits<double>::infinity();
  }
};

/// Ways from cell to neighbouring cell, of which there are eight (A*: Hart, Nilsson and Raphael
/// 1968; without a goal it is Dijkstra's algorithm). Complete: there is a way at this resolution if
/// and only if one is found.
///
/// A robot at the centres of two neighbours could still touch a corner halfway between. So centres
/// must have a little more room than the robot's radius r: sqrt(r^2 + (step / 2)^2), by which every
/// step is free for r.
class GridSearch {
 public:
  /// @param costmap outlives this; it has a map
  GridSearch(const Costmap& costmap, const ClearanceCost& cost);

  /// The cheapest path, whose ends are these very points. None if there is no way.
  /// @param from, to [m] where the robot fits; else there is no way
  [[nodiscard]] std::optional<Path> find(const Eigen::Vector2d& from,
                                         const Eigen::Vector2d& to) const;

  /// In metres, times what room costs.
  [[nodiscard]] TravelCosts costsFrom(const Eigen::Vector2d& from) const;

  /// Whether the centre of a cell may be part of a way.
  [[nodiscard]] bool isPassable(const grid::Cell& cell) const;

 private:
  struct Field;
  /// Cells about a point whose centre can be driven to straight from it.
  [[nodiscard]] std::vector<grid::Cell> cellsAbout(const Eigen::Vector2d& point) const;
  [[nodiscard]] Field makeField() const;
  void begin(Field& field, const Eigen::Vector2d& from) const;
  void expand(Field& field, std::size_t index) const;
  /// Until the goal is reached, or all that can be.
  void run(Field& field) const;
  /// The cells by which a cell is reached.
  [[nodiscard]] Path trace(const Field& field, grid::Cell cell) const;

  const Costmap& costmap_;
  ClearanceCost cost_;
  double room_;  ///< [m] that a centre needs
};

}  // namespace omega_slam::navigation

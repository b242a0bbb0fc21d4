#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "omega_slam/navigation/costmap.h"
#include "omega_slam/navigation/path.h"

namespace omega_slam::navigation {

/// The centre of a cell at which a way may begin, and what it costs to get there.
struct Departure {
  Eigen::Vector2d point;  ///< [m]
  double cost{0.0};       ///< in metres, times what room costs
};

/// What has come of a search.
struct SearchOutcome {
  std::optional<Path> path;
  double cost{0.0};       ///< of the path, in metres, times what room costs
  std::size_t looked{0};  ///< cells that it has gone on from; some more than once
  bool is_spent{false};   ///< it ended before it had looked everywhere: there may be a way
};

/// Ways from cell to neighbouring cell, of which there are eight (A*: Hart, Nilsson and Raphael
/// 1968). Complete: there is a way at this resolution if and only if one is found, unless the
/// cells that it may look at are spent. Once half of them are, it makes for the goal and no longer
/// for the cheapest way (as weighted A* does: Pohl, "Heuristic Search Viewed as Path Finding in a
/// Graph", 1970), so that it rather finds a way that is not the best than none.
///
/// A robot at the centres of two neighbours could still touch a corner halfway between. So centres
/// must have a little more room than the robot's radius r: sqrt(r^2 + (step / 2)^2), by which every
/// step is free for r.
class GridSearch {
 public:
  static constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

  /// @param costmap outlives this; it has a map
  /// @param max_looked cells that a search may go on from
  GridSearch(const Costmap& costmap, const ClearanceCost& cost, std::size_t max_looked = kNoLimit);

  /// The cheapest path, whose ends are these very points. None if there is no way.
  /// @param from, to [m] where the robot fits; else there is no way
  [[nodiscard]] SearchOutcome find(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  /// The cheapest path from any of some cells' centres, with what it costs to get there.
  [[nodiscard]] SearchOutcome findFromAny(const std::vector<Departure>& departures,
                                          const Eigen::Vector2d& to) const;

  /// Whether the centre of a cell may be part of a way.
  [[nodiscard]] bool isPassable(const grid::Cell& cell) const;

 private:
  struct Field;
  /// Cells about a point whose centre can be driven to straight from it.
  [[nodiscard]] std::vector<grid::Cell> cellsAbout(const Eigen::Vector2d& point) const;
  /// A field whose ways end at the cell that is nearest to a point; none where the robot can't
  /// stop.
  [[nodiscard]] std::optional<Field> fieldTowards(const Eigen::Vector2d& to) const;
  void open(Field& field, const grid::Cell& cell, double cost) const;
  void expand(Field& field, std::size_t index) const;
  void hurry(Field& field) const;
  /// Until the goal is reached, or all that can be, or the cells are spent.
  [[nodiscard]] SearchOutcome run(Field& field, const Eigen::Vector2d& to) const;
  /// The cells by which a cell is reached.
  [[nodiscard]] Path trace(const Field& field, grid::Cell cell) const;

  const Costmap& costmap_;
  ClearanceCost cost_;
  std::size_t max_looked_;
  double room_;  ///< [m] that a centre needs
};

}  // namespace omega_slam::navigation

#pragma once

#include <vector>

#include "omega_slam/exploration/map_view.h"
#include "omega_slam/grid/distance_field.h"

namespace omega_slam::exploration {

/// Where the middle of a round robot can be: in cells from which all that its body covers is known
/// to be free.
class StandingRoom {
 public:
  /// @param radius [m] of the robot, with what it keeps clear of
  StandingRoom(const MapView& map, double radius);

  [[nodiscard]] bool hasRoomAt(const Cell& cell) const {
    const Cell local = cell - corner_;
    return geometry().contains(local) && static_cast<double>(blocked_.atCell(local)) >= radius_;
  }
  /// The cells with room that are nearest to a point [m], as far as `reach` [m]: that of the point
  /// itself, or all that are equally near; none if there are none.
  [[nodiscard]] std::vector<Cell> nearestRoom(const Eigen::Vector2d& point, double reach) const;
  [[nodiscard]] const grid::GridGeometry& geometry() const { return blocked_.geometry(); }
  [[nodiscard]] const Cell& corner() const { return corner_; }  ///< number of the cell (0, 0)

 private:
  Cell corner_;
  double radius_;                ///< [m]
  grid::DistanceField blocked_;  ///< to cells that are not free
};

}  // namespace omega_slam::exploration

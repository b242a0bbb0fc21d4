#pragma once

#include <cstdint>
#include <vector>

#include "omega_slam/exploration/map_view.h"

namespace omega_slam::exploration {

/// Steps from the middle of a disc to the cells of whose squares it covers something.
/// @param radius [cells]
[[nodiscard]] std::vector<Cell> discAround(double radius);

/// Where the middle of a round robot can be: in cells from which all that its body covers is known
/// to be free. Cells on the edge of the map have no room.
class StandingRoom {
 public:
  /// Time is linear in the number of cells, and grows with the square of the radius for those on
  /// the edge of what is free.
  /// @param radius [m] of the robot, with what it keeps clear of
  StandingRoom(const MapView& map, double radius);

  [[nodiscard]] bool hasRoomAt(const Cell& cell) const {
    const Cell local = cell - corner_;
    return geometry_.contains(local) && room_[geometry_.index(local)] != 0;
  }
  /// The cells with room that are nearest to a point [m], as far as `reach` [m]: that of the point
  /// itself, or all that are equally near; none if there are none.
  [[nodiscard]] std::vector<Cell> nearestRoom(const Eigen::Vector2d& point, double reach) const;
  [[nodiscard]] const grid::GridGeometry& geometry() const { return geometry_; }
  [[nodiscard]] const Cell& corner() const { return corner_; }  ///< number of the cell (0, 0)

  /// Row-major, one byte a cell, not 0: room.
  [[nodiscard]] const std::vector<std::uint8_t>& room() const { return room_; }

 private:
  void block(const Cell& local, const std::vector<Cell>& disc);

  grid::GridGeometry geometry_;
  Cell corner_;
  std::vector<std::uint8_t> room_;
};

}  // namespace omega_slam::exploration

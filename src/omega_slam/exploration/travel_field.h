#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "omega_slam/exploration/standing_room.h"

namespace omega_slam::exploration {

/// How far it is from one place to everywhere else, along cells with room for the robot: Dijkstra's
/// search over eight neighbours, steps of 5 along and 7 across (Borgefors, "Distance
/// Transformations in Digital Images", 1986: within 2 % too short and 8 % too long), no cutting of
/// corners. Looks at the room, which must outlive it. Time is linear in the number of cells.
class TravelField {
 public:
  /// @param start [m] map frame. Without room there, the cells with room nearest to it begin the
  /// search, as far as `snap` [m].
  TravelField(const StandingRoom& room, const Eigen::Vector2d& start, double snap)
      : TravelField(room, room.nearestRoom(start, snap)) {}

  /// @param start cells with room, from all of which the search begins
  TravelField(const StandingRoom& room, const std::vector<Cell>& start);

  [[nodiscard]] double reachedArea() const;  ///< [m^2] of cells to which there is a way

  /// [m] none if there is no way.
  [[nodiscard]] std::optional<double> distanceTo(const Cell& cell) const;

  /// Centres of the cells on a shortest way from the start to the cell [m], both included; empty if
  /// there is no way.
  [[nodiscard]] std::vector<Eigen::Vector2d> pathTo(const Cell& cell) const;

 private:
  using Steps = std::uint32_t;
  using Index = std::ptrdiff_t;  ///< of a cell of the map
  [[nodiscard]] Index indexOf(const Cell& cell) const {
    return static_cast<Index>(room_->geometry().index(cell - room_->corner()));
  }
  [[nodiscard]] bool hasRoomAt(Index cell) const {
    return room_->room()[static_cast<std::size_t>(cell)] != 0;
  }
  [[nodiscard]] bool canStep(Index from, std::size_t neighbour) const;
  [[nodiscard]] Steps& at(Index cell) { return steps_[static_cast<std::size_t>(cell)]; }
  [[nodiscard]] Steps at(Index cell) const { return steps_[static_cast<std::size_t>(cell)]; }
  void spread(const std::vector<Cell>& from);

  const StandingRoom* room_;
  std::array<Index, 8> ways_{};  ///< from a cell to its neighbours. Those with room lie within the
                                 ///< edge of the map, so they have all of them
  std::vector<Steps> steps_;     ///< fifths of a cell
};

}  // namespace omega_slam::exploration

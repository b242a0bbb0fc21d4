#pragma once

#include <memory>
#include <vector>

#include "omega_slam/exploration/explorer.h"
#include "omega_slam/mapping/occupancy_mapper.h"
#include "omega_slam/simulation/world.h"

namespace omega_slam::test {

/// What a laser of 240 degrees in the middle of a robot sees of a world, without noise; beams that
/// meet nothing are free to the range. @param T_world_base inside of the world; @param range [m]
[[nodiscard]] sensing::Sweep sweepIn(const simulation::World& world,
                                     const geometry::Pose2& T_world_base, double range);

/// A robot without physics that knows its pose, draws its map, and goes where an explorer sends it
/// by the shortest way through its map. The map frame is the world's.
class ToyRobot {
 public:
  ToyRobot(std::shared_ptr<const simulation::World> world, const geometry::Pose2& start);

  /// Draws what it sees into the map, and shows the map to the explorer.
  void look(exploration::Explorer& explorer);

  /// A tick of 0.5 s: obeys the explorer, drives 0.3 m at most, and looks.
  void tick(exploration::Explorer& explorer);

  /// Ticks until the exploration has ended; @return whether it has within `max_ticks`.
  bool run(exploration::Explorer& explorer, int max_ticks);

  void refuseGoalsNear(const Eigen::Vector2d& place, double radius);

  [[nodiscard]] const geometry::Pose2& pose() const { return pose_; }
  [[nodiscard]] bool isDriving() const { return goal_.has_value(); }
  [[nodiscard]] double now() const { return now_; }
  [[nodiscard]] const grid::OccupancyGrid& map() const { return *map_; }
  [[nodiscard]] const std::vector<exploration::Order>& orders() const { return orders_; }

 private:
  void obey(const exploration::Order& order);
  void drive(exploration::Explorer& explorer);

  std::shared_ptr<const simulation::World> world_;
  mapping::OccupancyMapper mapper_;
  std::shared_ptr<const grid::OccupancyGrid> map_;
  geometry::Pose2 pose_;
  double now_{0.0};
  std::optional<exploration::Goal> goal_;
  std::vector<exploration::Order> orders_;  ///< all but those to keep on
  Eigen::Vector2d refused_{0.0, 0.0};
  double refused_radius_{-1.0};
};

}  // namespace omega_slam::test

#pragma once

#include <optional>
#include <vector>

#include "omega_slam/exploration/standing_room.h"
#include "omega_slam/exploration/strategy.h"
#include "omega_slam/exploration/travel_field.h"

namespace omega_slam::exploration {

/// The map as the robot has it before it at a moment: where there is room for it, how far it is to
/// everywhere, and what frontiers offer. Copies the map; its parts look at each other, so it stays
/// where it was made.
class Survey {
 public:
  /// @param touched [m] map frame: points of obstacles that the map does not show
  /// @param robot_radius, sensor_range [m] as in ExplorerConfig
  Survey(const grid::OccupancyGrid& map, const std::vector<Eigen::Vector2d>& touched,
         const geometry::Pose2& T_map_base, double robot_radius, double sensor_range);
  Survey(const Survey&) = delete;
  Survey& operator=(const Survey&) = delete;

  /// @param tried [m] viewpoints that have not helped
  /// @return none if the robot can get to no place from which it sees the frontier, or if that is
  /// short and lies in a gap that is too narrow for it
  [[nodiscard]] std::optional<Option> optionFor(const Frontier& frontier,
                                                const std::vector<Eigen::Vector2d>& tried) const;

  /// Whether a cell of a frontier is in sight from a place [m], from no farther than viewpoints
  /// are.
  [[nodiscard]] bool isSeenFrom(const Frontier& frontier, const Eigen::Vector2d& place) const;

  /// [m] from one place to another; infinity where there is no way.
  [[nodiscard]] double travelBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  /// [m] from one option's viewpoint to those of all; infinity where there is no way.
  [[nodiscard]] std::vector<double> travelBetween(const Option& from,
                                                  const std::vector<Option>& to) const;

  /// [m] from the viewpoints of all options to a place; infinity where there is no way.
  [[nodiscard]] std::vector<double> travelBetween(const std::vector<Option>& from,
                                                  const Eigen::Vector2d& to) const;

  /// [m] of the way to a point of the map frame, or to as near as the robot is wide; none if there
  /// is no way.
  [[nodiscard]] std::optional<double> travelTo(const Eigen::Vector2d& point) const;

  [[nodiscard]] double knownArea() const;  ///< [m^2] free and occupied
  [[nodiscard]] const StandingRoom& room() const { return room_; }

 private:
  [[nodiscard]] double turnTowards(const Eigen::Vector2d& point) const;

  grid::OccupancyGrid map_;
  MapView view_;
  geometry::Pose2 T_map_base_;
  double robot_radius_;
  double sensor_range_;
  StandingRoom room_;
  TravelField travel_;
};

}  // namespace omega_slam::exploration

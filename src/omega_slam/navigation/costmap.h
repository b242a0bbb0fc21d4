#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "omega_slam/grid/distance_field.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/navigation/contacts.h"
#include "omega_slam/navigation/live_obstacles.h"
#include "omega_slam/navigation/seen_walls.h"

namespace omega_slam::navigation {

struct CostmapConfig {
  int occupied_threshold{50};     ///< [%] cells of the map from this value on are obstacles
  bool unknown_is_free{false};    ///< whether plans may lead through what the map does not know
  double reach{4.0};              ///< [m] around the robot in which live obstacles are remembered
  double memory{8.0};             ///< [s] an obstacle lasts that is no longer looked at
  double contact_memory{3600.0};  ///< [s] a place lasts where the robot has bumped into something

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// Where a round robot can be: the map, and what its sensors see now. All points [m] in the map's
/// frame. Two questions are asked of it, and unknown cells make the difference:
///   planning asks whether a place is *free*: known, and without an obstacle;
///   driving asks for the way to the next *solid* obstacle, since a robot may well stand where its
///   map is not drawn yet, and its laser looks ahead.
/// What lies beyond the map's edge is unknown. Not thread-safe; without changes, any number of
/// threads may ask.
class Costmap {
 public:
  /// @throws std::invalid_argument if the configuration is not valid
  explicit Costmap(const CostmapConfig& config);

  /// Replaces the map, in time linear in its cells. Live obstacles stay.
  void setMap(const grid::OccupancyGrid& map);
  [[nodiscard]] bool hasMap() const { return blocked_ && blocked_->geometry().size() > 0; }
  [[nodiscard]] const grid::GridGeometry& geometry() const { return blocked_->geometry(); }
  [[nodiscard]] const grid::OccupancyGrid& map() const { return *map_; }  ///< once there is one

  /// What is seen within a cell's edge of an obstacle of the map is that obstacle, for plans: the
  /// laser's noise would make doors narrower than they are. But the robot keeps off where it is
  /// seen to begin: maps are drawn a few centimetres off.
  /// @param sighting in the map's frame; @param robot [m] about which to remember
  void see(const Sighting& sighting, const Eigen::Vector2d& robot);
  /// @param points [m] where the robot touches something, at time `now` [s]
  void touch(const std::vector<Eigen::Vector2d>& points, double now);
  /// What was touched moves with the map; what is seen now comes anew.
  void moveTouched(const geometry::MapMotion& motion) { contacts_.move(motion); }
  void expire(double now);
  void forgetSeen();  ///< but not what was touched
  void forgetLive();  ///< what was touched, too

  /// What the map says of a cell. Outside of the map all is unknown; where plans may lead through
  /// unknown cells, none inside of it is.
  [[nodiscard]] bool isOccupied(const grid::Cell& cell) const;
  [[nodiscard]] bool isUnknown(const grid::Cell& cell) const;

  /// Whether a disc touches neither an obstacle nor, unless that is allowed, an unknown cell.
  /// Exact.
  [[nodiscard]] bool isFree(const Eigen::Vector2d& point, double radius) const;
  /// As above for the disc on all of its way from one point to the other, up to a few 0.1 mm.
  [[nodiscard]] bool isFree(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                            double radius) const;
  /// As isFree() for the centre of a cell of the map.
  [[nodiscard]] bool isFree(const grid::Cell& cell, double radius) const {
    return static_cast<double>(blocked_->atCell(cell)) >= radius &&
           isFreeOfLive(geometry().center(cell), radius);
  }

  /// At least so far [m] is it to what isFree() minds, and at most a cell's diagonal farther.
  [[nodiscard]] double clearance(const Eigen::Vector2d& point) const;
  /// So far [m], to a few millimetres, is it to the next obstacle, unknown cells aside.
  [[nodiscard]] double solidClearance(const Eigen::Vector2d& point) const {
    return roomAt(point).solid;
  }
  struct Room {
    double solid{0.0};  ///< [m] as solidClearance()
    double seen{0.0};   ///< [m] to the nearest that was seen lately; beams may be a little short
  };
  [[nodiscard]] Room roomAt(const Eigen::Vector2d& point) const;

 private:
  [[nodiscard]] bool isWall(const Eigen::Vector2d& point) const;
  [[nodiscard]] Sighting withoutWalls(const Sighting& sighting) const;
  /// Whether a disc touches nothing that was seen or touched.
  [[nodiscard]] bool isFreeOfLive(const Eigen::Vector2d& point, double radius) const {
    return live_.field().isClear(point, radius) && contacts_.field().isClear(point, radius);
  }

  CostmapConfig config_;
  // Shared by copies, since they never change.
  std::shared_ptr<const grid::DistanceField> solid_;    ///< to occupied cells
  std::shared_ptr<const grid::DistanceField> blocked_;  ///< to occupied and unknown cells
  std::shared_ptr<const grid::OccupancyGrid> map_;
  LiveObstacles live_;
  SeenWalls walls_;
  Contacts contacts_;
};

}  // namespace omega_slam::navigation

#include "omega_slam/exploration/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "omega_slam/exploration/approach.h"
#include "omega_slam/exploration/information_gain.h"
#include "omega_slam/exploration/own_place.h"
#include "omega_slam/geometry/angle.h"

namespace omega_slam::exploration {
namespace {

constexpr double kSnap = 1.0;          // [m] from a robot that is too close to something to room
constexpr double kPocket = 1.0;        // [m^2] of room that is taken to be closed by mistake
constexpr double kViewDistance = 2.0;  // [m] viewpoints farther from a frontier are none
constexpr double kShort = 1.0;         // [m] a shorter frontier in a gap too narrow is left alone
constexpr double kWayAhead = 0.5;      // [m] of a way that tell the direction in which it begins

/// The map with obstacles at those points.
grid::OccupancyGrid blockedAt(const std::vector<Eigen::Vector2d>& points, grid::OccupancyGrid map) {
  for (const Eigen::Vector2d& point : points) {
    if (const Cell cell = map.geometry.cellAt(point); map.geometry.contains(cell)) {
      map.at(cell) = grid::kOccupied;
    }
  }
  return map;
}

/// A navigation goes by the map as it is, and lets the robot out of where it does not fit; only
/// where there is no room nearby at all, the robot's own place counts as free, so that it can turn
/// around.
StandingRoom roomFor(const grid::OccupancyGrid& map, const MapView& with_own_place, double radius,
                     const Eigen::Vector2d& position) {
  StandingRoom room(MapView(map), radius);
  return room.nearestRoom(position, kSnap).empty() ? StandingRoom(with_own_place, radius)
                                                   : std::move(room);
}

/// The cells with room around a place that can be seen from there.
std::vector<Cell> roomInSight(const StandingRoom& room, const MapView& map,
                              const Eigen::Vector2d& place) {
  std::vector<Cell> cells = room.nearestRoom(place, kSnap);
  const Cell here = map.cellAt(place);
  for (const Cell& step : discAround(kSnap / map.geometry().resolution)) {
    if (room.hasRoomAt(here + step) && isInSight(map, here, here + step)) {
      cells.push_back(here + step);
    }
  }
  return cells;
}

/// From where the robot is. It may stand in a pocket between table legs which the map, a cell off,
/// shows closed; as it has got in, it gets out to the room that it sees around.
TravelField travelFrom(const StandingRoom& room, const MapView& map, const Eigen::Vector2d& place) {
  TravelField travel(room, place, kSnap);
  return travel.reachedArea() < kPocket ? TravelField(room, roomInSight(room, map, place))
                                        : std::move(travel);
}

}  // namespace

Survey::Survey(const grid::OccupancyGrid& map, const std::vector<Eigen::Vector2d>& touched,
               const geometry::Pose2& T_map_base, double robot_radius, double sensor_range)
    : map_(withOwnPlaceFree(blockedAt(touched, map), T_map_base.translation(), robot_radius)),
      view_(map_),
      T_map_base_(T_map_base),
      robot_radius_(robot_radius),
      sensor_range_(sensor_range),
      room_(roomFor(blockedAt(touched, map), view_, robot_radius, T_map_base.translation())),
      travel_(travelFrom(room_, view_, T_map_base.translation())) {}

double Survey::turnTowards(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d way = point - T_map_base_.translation();
  if (way.norm() < map_.geometry.resolution) {
    return 0.0;
  }
  return std::abs(geometry::angleDifference(std::atan2(way.y(), way.x()), T_map_base_.theta));
}

std::optional<Option> Survey::optionFor(const Frontier& frontier,
                                        const std::vector<Eigen::Vector2d>& tried) const {
  if (frontier.size < kShort && !canComeUpTo(frontier, view_, robot_radius_)) {
    return std::nullopt;
  }
  const auto viewpoint =
      findViewpoint(frontier, view_, travel_, tried, std::min(kViewDistance, sensor_range_));
  if (!viewpoint) {
    return std::nullopt;
  }
  const Eigen::Vector2d place = viewpoint->T_map_base.translation();
  const auto path = travel_.pathTo(view_.cellAt(place));
  const auto ahead = std::find_if(path.begin(), path.end(), [this](const Eigen::Vector2d& point) {
    return (point - T_map_base_.translation()).norm() >= kWayAhead;
  });
  const bool is_here = path.size() < 2;
  const double turn =
      is_here ? std::abs(geometry::angleDifference(viewpoint->T_map_base.theta, T_map_base_.theta))
              : turnTowards(ahead == path.end() ? place : *ahead);
  return Option{frontier.id, *viewpoint, expectedGain(view_, place, sensor_range_), turn};
}

bool Survey::isSeenFrom(const Frontier& frontier, const Eigen::Vector2d& place) const {
  const Cell from = view_.cellAt(place);
  return std::any_of(frontier.cells.begin(), frontier.cells.end(), [&](const Cell& cell) {
    return (view_.center(cell) - place).norm() <= std::min(kViewDistance, sensor_range_) &&
           isInSight(view_, from, cell);
  });
}

double Survey::travelBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  return TravelField(room_, from, kSnap)
      .distanceTo(view_.cellAt(to))
      .value_or(std::numeric_limits<double>::infinity());
}

std::vector<double> Survey::travelBetween(const Option& from, const std::vector<Option>& to) const {
  return travelBetween(to, from.viewpoint.T_map_base.translation());
}

std::vector<double> Survey::travelBetween(const std::vector<Option>& from,
                                          const Eigen::Vector2d& to) const {
  const TravelField field(room_, to, kSnap);  // ways are as long in both directions
  std::vector<double> lengths;
  for (const Option& option : from) {
    lengths.push_back(field.distanceTo(view_.cellAt(option.viewpoint.T_map_base.translation()))
                          .value_or(std::numeric_limits<double>::infinity()));
  }
  return lengths;
}

std::optional<double> Survey::travelTo(const Eigen::Vector2d& point) const {
  const Cell center = view_.cellAt(point);
  const int reach = static_cast<int>(std::ceil(robot_radius_ / map_.geometry.resolution));
  std::optional<double> least;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      if (const auto travel = travel_.distanceTo(center + Cell(x, y))) {
        const double whole = *travel + map_.geometry.resolution * std::hypot(x, y);
        least = std::min(least.value_or(whole), whole);
      }
    }
  }
  return least;
}

double Survey::knownArea() const {
  const auto known = std::count_if(map_.cells.begin(), map_.cells.end(), [](std::int8_t value) {
    return stateOf(value) != CellState::kUnknown;
  });
  return static_cast<double>(known) * map_.geometry.resolution * map_.geometry.resolution;
}

}  // namespace omega_slam::exploration

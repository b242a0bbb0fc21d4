#include "omega_slam/exploration/approach.h"

#include <algorithm>
#include <vector>

#include "omega_slam/exploration/standing_room.h"
#include "omega_slam/exploration/viewpoint.h"

namespace omega_slam::exploration {
namespace {

constexpr double kBeside = 0.15;  // [m] between the robot and a frontier that it has come up to

bool isFreeOfObstacles(const MapView& map, const Cell& place, const std::vector<Cell>& body) {
  return std::none_of(body.begin(), body.end(), [&](const Cell& step) {
    return map.at(place + step) == CellState::kOccupied;
  });
}

}  // namespace

bool canComeUpTo(const Frontier& frontier, const MapView& map, double radius) {
  const double resolution = map.geometry().resolution;
  const std::vector<Cell> body = discAround(radius / resolution);
  const std::vector<Cell> nearby = discAround((radius + kBeside) / resolution);
  CellSet met;  // places that were looked at: neighbours share most of theirs
  return std::any_of(frontier.cells.begin(), frontier.cells.end(), [&](const Cell& cell) {
    return std::any_of(nearby.begin(), nearby.end(), [&](const Cell& step) {
      const Cell place = cell + step;
      return map.isFree(place) && isInSight(map, place, cell) && met.insert(place).second &&
             isFreeOfObstacles(map, place, body);
    });
  });
}

}  // namespace omega_slam::exploration

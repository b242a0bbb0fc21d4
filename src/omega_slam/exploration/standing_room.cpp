#include "omega_slam/exploration/standing_room.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace omega_slam::exploration {
namespace {

grid::DistanceField distancesToBlocked(const grid::OccupancyGrid& map) {
  std::vector<std::uint8_t> blocked(map.cells.size());
  for (std::size_t i = 0; i < blocked.size(); ++i) {
    blocked[i] = stateOf(map.cells[i]) == CellState::kFree ? 0 : 1;
  }
  return {map.geometry, std::move(blocked), grid::Outside::kObstacle};
}

}  // namespace

StandingRoom::StandingRoom(const MapView& map, double radius)
    : corner_(map.corner()), radius_(radius), blocked_(distancesToBlocked(map.map())) {}

std::vector<Cell> StandingRoom::nearestRoom(const Eigen::Vector2d& point, double reach) const {
  const Cell here = geometry().cellAt(point) + corner_;
  if (hasRoomAt(here)) {
    return {here};
  }
  const int radius = static_cast<int>(std::ceil(reach / geometry().resolution));
  int nearest = radius * radius + 1;
  std::vector<Cell> cells;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      const int distance = x * x + y * y;
      if (distance > nearest || !hasRoomAt(here + Cell(x, y))) {
        continue;
      }
      if (distance < nearest) {
        cells.clear();
        nearest = distance;
      }
      cells.emplace_back(here + Cell(x, y));
    }
  }
  return cells;
}

}  // namespace omega_slam::exploration

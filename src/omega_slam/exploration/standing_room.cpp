#include "omega_slam/exploration/standing_room.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace omega_slam::exploration {

std::vector<Cell> discAround(double radius) {
  const int reach = static_cast<int>(std::ceil(radius + 0.5));
  std::vector<Cell> disc;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const double across = std::max(0.0, std::abs(x) - 0.5);
      const double along = std::max(0.0, std::abs(y) - 0.5);
      if (std::hypot(across, along) < radius) {
        disc.emplace_back(x, y);
      }
    }
  }
  return disc;
}

StandingRoom::StandingRoom(const MapView& map, double radius)
    : geometry_(map.geometry()), corner_(map.corner()), room_(map.map().cells.size(), 0) {
  const double cells = radius / geometry_.resolution;
  const int rim = std::max(1, static_cast<int>(std::ceil(cells - 0.5)));  // beside the outside
  const auto isFree = [&](const Cell& local) {
    return geometry_.contains(local) && stateOf(map.map().at(local)) == CellState::kFree;
  };
  for (int y = rim; y < geometry_.height - rim; ++y) {
    for (int x = rim; x < geometry_.width - rim; ++x) {
      room_[geometry_.index({x, y})] = isFree({x, y}) ? 1 : 0;
    }
  }
  // What lies behind the edge of what is blocked blocks nothing that the edge does not.
  const std::vector<Cell> disc = discAround(cells);
  for (int y = 0; y < geometry_.height; ++y) {
    for (int x = 0; x < geometry_.width; ++x) {
      const Cell local(x, y);
      if (!isFree(local) && std::any_of(kNeighbours.begin(), kNeighbours.end(),
                                        [&](const Cell& step) { return isFree(local + step); })) {
        block(local, disc);
      }
    }
  }
}

void StandingRoom::block(const Cell& local, const std::vector<Cell>& disc) {
  for (const Cell& step : disc) {
    if (geometry_.contains(local + step)) {
      room_[geometry_.index(local + step)] = 0;
    }
  }
}

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

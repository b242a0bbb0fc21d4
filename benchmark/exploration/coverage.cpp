#include "exploration/coverage.h"

#include <cmath>

#include "omega_slam/exploration/standing_room.h"
#include "omega_slam/exploration/travel_field.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/ray_traversal.h"
#include "omega_slam/sensing/scan_intake.h"

namespace omega_slam::experiments {
namespace {

using grid::Cell;

constexpr int kRays = 512;     // all round, from each place
constexpr int kPlaceStep = 3;  // [cells] between places that are looked from

/// All that does not stop a robot is free.
grid::OccupancyGrid floorOf(const simulation::World& world) {
  grid::OccupancyGrid map = grid::makeGrid(world.geometry(), grid::kFree);
  for (int row = 0; row < map.geometry.height; ++row) {
    for (int col = 0; col < map.geometry.width; ++col) {
      if (world.at({col, row}) != simulation::Material::kNone) {
        map.at({col, row}) = grid::kOccupied;
      }
    }
  }
  return map;
}

void look(const simulation::World& world, const Eigen::Vector2d& place, double range,
          std::vector<bool>& seen) {
  const grid::GridGeometry& geometry = world.geometry();
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2.0 * geometry::kPi * i / kRays;
    const auto hit = world.castRay(place, angle, range);
    const double reach = hit ? hit->range : sensing::ScanIntakeConfig().no_return_range;
    const Eigen::Vector2d end = place + reach * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    grid::traverseRay(geometry, place, end, [&](const Cell& cell) {
      if (geometry.contains(cell) && world.at(cell) == simulation::Material::kNone) {
        seen[geometry.index(cell)] = true;
      }
    });
  }
}

bool isKnownAround(const grid::OccupancyGrid& map, const Cell& center) {
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      const Cell cell = center + Cell(x, y);
      if (map.geometry.contains(cell) && map.at(cell) != grid::kUnknown) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<Eigen::Vector2d> standingRoom(const simulation::World& world,
                                          const Eigen::Vector2d& start, double radius) {
  const grid::OccupancyGrid floor = floorOf(world);
  const exploration::MapView view(floor);
  const exploration::StandingRoom room(view, radius);
  const exploration::TravelField travel(room, start, radius);
  std::vector<Eigen::Vector2d> places;
  for (int row = 0; row < floor.geometry.height; ++row) {
    for (int col = 0; col < floor.geometry.width; ++col) {
      if (travel.distanceTo(Cell(col, row) + view.corner())) {
        places.push_back(floor.geometry.center({col, row}));
      }
    }
  }
  return places;
}

Seeable::Seeable(const simulation::World& world, const Eigen::Vector2d& start, double radius,
                 double range)
    : cell_area_(world.geometry().resolution * world.geometry().resolution) {
  const grid::GridGeometry& geometry = world.geometry();
  std::vector<bool> seen(geometry.size());
  for (const Eigen::Vector2d& place : standingRoom(world, start, radius)) {
    const Cell cell = geometry.cellAt(place);
    if (cell.x() % kPlaceStep == 0 && cell.y() % kPlaceStep == 0) {
      look(world, place, range, seen);
    }
  }
  for (int row = 0; row < geometry.height; ++row) {
    for (int col = 0; col < geometry.width; ++col) {
      if (seen[geometry.index({col, row})]) {
        cells_.push_back(geometry.center({col, row}));
      }
    }
  }
}

double Seeable::area() const { return cell_area_ * static_cast<double>(cells_.size()); }

double Seeable::knownShare(const grid::OccupancyGrid& map,
                           const geometry::Pose2& T_world_map) const {
  if (map.cells.empty() || cells_.empty()) {
    return 0.0;
  }
  const geometry::Pose2 T_map_world = T_world_map.inverse();
  std::size_t known = 0;
  for (const Eigen::Vector2d& cell : cells_) {
    known += isKnownAround(map, map.geometry.cellAt(T_map_world * cell)) ? 1 : 0;
  }
  return static_cast<double>(known) / static_cast<double>(cells_.size());
}

}  // namespace omega_slam::experiments

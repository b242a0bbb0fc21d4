#include "exploration/place.h"

#include <random>
#include <utility>
#include <vector>

#include "exploration/coverage.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/map_file.h"
#include "omega_slam/simulation/world_file.h"

namespace omega_slam::experiments {
namespace {

constexpr const char* kWorldFile = ".world.yaml";
constexpr double kStartRoom = 0.12;  // [m] beside a robot at a random start

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool isEdge(const grid::GridGeometry& geometry, const grid::Cell& cell) {
  return cell.x() == 0 || cell.y() == 0 || cell.x() + 1 == geometry.width ||
         cell.y() + 1 == geometry.height;
}

/// Walls wherever the map does not know that there are none.
simulation::World closedWorld(const grid::OccupancyGrid& map) {
  const grid::GridGeometry& geometry = map.geometry;
  std::vector<simulation::Material> cells(map.cells.size(), simulation::Material::kWall);
  for (int row = 0; row < geometry.height; ++row) {
    for (int column = 0; column < geometry.width; ++column) {
      const grid::Cell cell(column, row);
      if (map.at(cell) == grid::kFree && !isEdge(geometry, cell)) {
        cells[geometry.index(cell)] = simulation::Material::kNone;
      }
    }
  }
  return {geometry, std::move(cells)};
}

}  // namespace

Place loadPlace(const std::string& file) {
  if (endsWith(file, kWorldFile)) {
    const simulation::LoadedWorld loaded = simulation::loadWorld(file);
    return {loaded.world, loaded.file.start};
  }
  auto world = std::make_shared<const simulation::World>(
      closedWorld(grid::toOccupancyGrid(grid::loadMapImage(file))));
  const grid::GridGeometry& geometry = world->geometry();
  const Eigen::Vector2d middle = geometry.center({geometry.width / 2, geometry.height / 2});
  return {std::move(world), {middle.x(), middle.y(), 0.0}};
}

geometry::Pose2 randomStart(const Place& place, double radius, std::uint64_t seed) {
  constexpr int kAttempts = 10000;
  std::mt19937_64 random(seed);
  const std::vector<Eigen::Vector2d> room =
      standingRoom(*place.world, place.T_world_start.translation(), radius);
  std::uniform_int_distribution<std::size_t> cell(0, room.size() - 1);
  std::uniform_real_distribution<double> heading(-geometry::kPi, geometry::kPi);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Eigen::Vector2d point = room[cell(random)];
    if (!place.world->nearestObstacle(point, radius + kStartRoom)) {
      return {point.x(), point.y(), heading(random)};
    }
  }
  return place.T_world_start;
}

}  // namespace omega_slam::experiments

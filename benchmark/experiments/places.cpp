#include "experiments/places.h"

#include <stdexcept>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/map_file.h"
#include "omega_slam/sensing/scan_intake.h"
#include "omega_slam/slam/keyframe.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

constexpr int kMaxDraws = 100000;

matching::View viewBy(const simulation::HokuyoConfig& laser, const Arena& arena,
                      const Pose2& T_world_base, std::uint64_t seed) {
  sensing::LaserMount mount;
  mount.T_base_laser = simulation::TurtleBotConfig{}.T_base_laser;
  const Pose2 T_world_laser = T_world_base * mount.T_base_laser;
  simulation::Hokuyo hokuyo(laser, 0.0, seed);
  // The last beam is taken well before the mirror has made its turn.
  const double end = 0.99 * hokuyo.scanPeriod();
  const auto scan = hokuyo.sweep(arena.world, {0.0, T_world_laser}, {end, T_world_laser});
  const auto sweep = sensing::ScanIntake({}).process(scan.value(), mount).sweep;
  return sweep ? slam::viewOf(*sweep)
               : matching::View{{}, mount.T_base_laser.translation()};  // not one return
}

}  // namespace

Arena loadArena(const std::string& name, const std::filesystem::path& map_file) {
  const grid::MapImage image = grid::loadMapImage(map_file);
  return {name, simulation::World::fromImage(image), grid::toOccupancyGrid(image)};
}

std::mt19937_64 generatorFor(std::initializer_list<std::uint32_t> key) {
  std::seed_seq sequence(key);
  return std::mt19937_64(sequence);
}

bool isFree(const Arena& arena, const Eigen::Vector2d& place) {
  const double radius = simulation::KobukiConfig{}.radius;
  if (arena.world.nearestObstacle(place, radius)) {
    return false;
  }
  const grid::GridGeometry& geometry = arena.map.geometry;
  const Eigen::Vector2d reach(radius, radius);
  const grid::Cell low = geometry.cellAt(place - reach);
  const grid::Cell high = geometry.cellAt(place + reach);
  for (int row = low.y(); row <= high.y(); ++row) {
    for (int column = low.x(); column <= high.x(); ++column) {
      const grid::Cell cell(column, row);
      if ((geometry.center(cell) - place).norm() < radius &&
          (!geometry.contains(cell) || arena.map.at(cell) != grid::kFree)) {
        return false;
      }
    }
  }
  return true;
}

Pose2 drawFreePose(const Arena& arena, std::mt19937_64& random) {
  const grid::GridGeometry& geometry = arena.map.geometry;
  std::uniform_real_distribution<double> x(0.0, geometry.width * geometry.resolution);
  std::uniform_real_distribution<double> y(0.0, geometry.height * geometry.resolution);
  std::uniform_real_distribution<double> heading(-geometry::kPi, geometry::kPi);
  for (int draw = 0; draw < kMaxDraws; ++draw) {
    const double column = x(random);
    const double row = y(random);
    const Eigen::Vector2d place = geometry.origin + Eigen::Vector2d(column, row);
    if (isFree(arena, place)) {
      return {place.x(), place.y(), heading(random)};
    }
  }
  throw std::runtime_error("The robot fits nowhere in " + arena.name + ".");
}

matching::View takeScan(const Arena& arena, const Pose2& T_world_base, std::mt19937_64& random) {
  return viewBy({}, arena, T_world_base, random());
}

matching::View takePerfectScan(const Arena& arena, const Pose2& T_world_base) {
  simulation::HokuyoConfig laser;
  laser.near_accuracy = 0.0;
  laser.far_accuracy = 0.0;
  return viewBy(laser, arena, T_world_base, 0);
}

double rangeDeviation(double range) {
  const simulation::HokuyoConfig laser;
  const double bound = range < laser.near_limit ? laser.near_accuracy : laser.far_accuracy * range;
  return bound / laser.accuracy_in_deviations;
}

}  // namespace omega_slam::experiments

#include "omega_slam/navigation/costmap.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::navigation {
namespace {

constexpr double kLiveResolution = 0.05;  // [m]
constexpr double kBeamError = 0.02;  // [m] by which the nearest of many beams is too short, about

const CostmapConfig& checked(const CostmapConfig& config) {
  geometry::throwIfAny(config.validate());
  return config;
}

template <typename Predicate>
std::shared_ptr<const grid::DistanceField> fieldOf(const grid::OccupancyGrid& map,
                                                   grid::Outside outside, Predicate&& blocks) {
  std::vector<std::uint8_t> obstacles(map.cells.size());
  std::transform(map.cells.begin(), map.cells.end(), obstacles.begin(), [&](std::int8_t value) {
    return static_cast<std::uint8_t>(blocks(value) ? 1 : 0);
  });
  return std::make_shared<grid::DistanceField>(map.geometry, std::move(obstacles), outside);
}

}  // namespace

std::vector<std::string> CostmapConfig::validate() const {
  geometry::Violations violations;
  violations.requireWithin("occupied_threshold", occupied_threshold, 1.0, 100.0);
  violations.requireWithin("reach", reach, 0.5, 50.0);
  violations.requireAtLeast("memory", memory, 0.0);
  violations.requireAtLeast("contact_memory", contact_memory, 0.0);
  return violations.sentences();
}

Costmap::Costmap(const CostmapConfig& config)
    : config_(checked(config)), live_(kLiveResolution, config.reach), contacts_(kLiveResolution) {}

void Costmap::setMap(const grid::OccupancyGrid& map) {
  map_ = std::make_shared<grid::OccupancyGrid>(map);
  const auto occupied = [&](std::int8_t value) { return value >= config_.occupied_threshold; };
  solid_ = fieldOf(map, grid::Outside::kOpen, occupied);
  if (config_.unknown_is_free) {
    blocked_ = fieldOf(map, grid::Outside::kObstacle, occupied);
  } else {
    blocked_ = fieldOf(map, grid::Outside::kObstacle, [&](std::int8_t value) {
      return value == grid::kUnknown || occupied(value);
    });
  }
}

void Costmap::see(const Sighting& sighting, const Eigen::Vector2d& robot) {
  live_.center(robot);
  live_.see(solid_ ? withoutWalls(sighting) : sighting, config_.memory);
  std::vector<Eigen::Vector2d> walls;
  std::copy_if(sighting.returns.begin(), sighting.returns.end(), std::back_inserter(walls),
               [this](const Eigen::Vector2d& point) { return isWall(point); });
  walls_.see(walls, robot, sighting.stamp);
}

bool Costmap::isWall(const Eigen::Vector2d& point) const {
  return solid_ && point.allFinite() && !solid_->isClear(point, geometry().resolution);
}

Sighting Costmap::withoutWalls(const Sighting& sighting) const {
  Sighting news;
  news.stamp = sighting.stamp;
  news.origin = sighting.origin;
  news.clear = sighting.clear;
  for (const Eigen::Vector2d& point : sighting.returns) {
    (isWall(point) ? news.clear : news.returns).push_back(point);
  }
  return news;
}

void Costmap::touch(const std::vector<Eigen::Vector2d>& points, double now) {
  contacts_.add(points, now + config_.contact_memory);
}

void Costmap::expire(double now) {
  live_.expire(now);
  contacts_.expire(now);
}

void Costmap::forgetSeen() {
  live_.forget();
  walls_.forget();
}

void Costmap::forgetLive() {
  forgetSeen();
  contacts_.forget();
}

bool Costmap::isOccupied(const grid::Cell& cell) const {
  return map_ && map_->geometry.contains(cell) && map_->at(cell) >= config_.occupied_threshold;
}

bool Costmap::isUnknown(const grid::Cell& cell) const {
  return !map_ || !map_->geometry.contains(cell) ||
         (map_->at(cell) == grid::kUnknown && !config_.unknown_is_free);
}

bool Costmap::isFree(const Eigen::Vector2d& point, double radius) const {
  return blocked_ && blocked_->isClear(point, radius) && isFreeOfLive(point, radius);
}

bool Costmap::isFree(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius) const {
  const Eigen::Vector2d way = to - from;
  const double length = way.norm();
  // Where there is room, by as much as there is; where there is none, in steps between which a
  // corner can reach no more than step^2 / (8 radius) into the way.
  const double least_step = 0.25 * geometry().resolution;
  for (double done = 0.0; done < length;) {
    const Eigen::Vector2d point = from + way * (done / length);
    const double room = clearance(point) - radius;
    if (room < 0.0 && !isFree(point, radius)) {
      return false;
    }
    done += std::max(room, least_step);
  }
  return isFree(to, radius);
}

double Costmap::clearance(const Eigen::Vector2d& point) const {
  return blocked_ ? std::min({blocked_->lowerBound(point), live_.field().lowerBound(point),
                              contacts_.field().lowerBound(point)})
                  : 0.0;
}

Costmap::Room Costmap::roomAt(const Eigen::Vector2d& point) const {
  const double live = live_.field().interpolated(point);
  const double wall = walls_.distance(point);
  const double drawn =
      solid_ ? solid_->interpolated(point) : std::numeric_limits<double>::infinity();
  return {std::min({drawn, live, contacts_.field().interpolated(point), wall + kBeamError}),
          std::min(live, wall)};
}

}  // namespace omega_slam::navigation

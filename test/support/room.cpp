#include "support/room.h"

#include <cmath>
#include <limits>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::test {

void Room::addBox(const Eigen::Vector2d& min, const Eigen::Vector2d& max) {
  const Eigen::Vector2d right(max.x(), min.y());
  const Eigen::Vector2d left(min.x(), max.y());
  walls.insert(walls.end(), {{min, right}, {right, max}, {max, left}, {left, min}});
}

double Room::castRay(const Eigen::Vector2d& origin, double angle) const {
  const Eigen::Vector2d d(std::cos(angle), std::sin(angle));
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) {
    const Eigen::Vector2d e = wall.end - wall.start;
    const double cross = d.x() * e.y() - d.y() * e.x();
    if (std::abs(cross) < 1e-12) {
      continue;
    }
    const Eigen::Vector2d s = wall.start - origin;
    const double along_ray = (s.x() * e.y() - s.y() * e.x()) / cross;
    const double along_wall = (s.x() * d.y() - s.y() * d.x()) / cross;
    if (along_ray > 0.0 && along_wall >= 0.0 && along_wall <= 1.0) {
      nearest = std::min(nearest, along_ray);
    }
  }
  return nearest;
}

Room furnishedRoom() {
  Room room;
  room.addBox({-4.0, -3.0}, {4.0, 3.0});
  room.addBox({2.0, -3.0}, {3.2, -2.2});
  room.addBox({-1.8, 1.0}, {-1.4, 1.4});
  room.walls.push_back({{-4.0, -0.5}, {-2.8, -0.5}});
  return room;
}

Room endlessCorridor() {
  Room room;
  room.walls.push_back({{-1000.0, -1.0}, {1000.0, -1.0}});
  room.walls.push_back({{-1000.0, 1.0}, {1000.0, 1.0}});
  return room;
}

sensing::LaserScan measure(const Room& room, const geometry::Pose2& T_room_laser, int beams,
                           double noise, std::mt19937_64& random, double range_max) {
  sensing::LaserScan scan;
  scan.angle_increment = 2.0 * geometry::kPi / beams;
  scan.angle_min = -geometry::kPi;
  scan.range_min = 0.05;
  scan.range_max = range_max;
  std::normal_distribution<double> error(0.0, noise > 0.0 ? noise : 1.0);
  for (int i = 0; i < beams; ++i) {
    const double angle = scan.angle_min + i * scan.angle_increment;
    double range = room.castRay(T_room_laser.translation(), T_room_laser.theta + angle);
    range += noise > 0.0 ? error(random) : 0.0;
    scan.ranges.push_back(range > range_max ? std::numeric_limits<float>::infinity()
                                            : static_cast<float>(range));
  }
  return scan;
}

std::vector<Eigen::Vector2d> measurePoints(const Room& room, const geometry::Pose2& T_room_laser,
                                           int beams, double noise, std::mt19937_64& random,
                                           double range_max) {
  const sensing::LaserScan scan = measure(room, T_room_laser, beams, noise, random, range_max);
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (std::isfinite(scan.ranges[i])) {
      const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
      points.emplace_back(scan.ranges[i] * std::cos(angle), scan.ranges[i] * std::sin(angle));
    }
  }
  return points;
}

}  // namespace omega_slam::test

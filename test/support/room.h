#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/laser_scan.h"

namespace omega_slam::test {

/// A room of straight walls, to be measured by a laser without a simulator in between.
struct Room {
  struct Wall {
    Eigen::Vector2d start;
    Eigen::Vector2d end;
  };
  std::vector<Wall> walls;

  /// Adds the four walls of a box. @param min, max opposite corners [m]
  void addBox(const Eigen::Vector2d& min, const Eigen::Vector2d& max);

  /// Distance to the nearest wall along a ray [m]; infinity where there is none.
  [[nodiscard]] double castRay(const Eigen::Vector2d& origin, double angle) const;
};

/// 8 x 6 m around the origin with a cupboard and a pillar: no two places look alike.
[[nodiscard]] Room furnishedRoom();

/// Two parallel walls along x, 2 m apart, longer than any laser sees.
[[nodiscard]] Room endlessCorridor();

/// A full turn of `beams` beams from a pose in the room, with normal noise of the range [m].
[[nodiscard]] sensing::LaserScan measure(const Room& room, const geometry::Pose2& T_room_laser,
                                         int beams, double noise, std::mt19937_64& random,
                                         double range_max = 10.0);

/// The same as points in the laser's frame.
[[nodiscard]] std::vector<Eigen::Vector2d> measurePoints(const Room& room,
                                                         const geometry::Pose2& T_room_laser,
                                                         int beams, double noise,
                                                         std::mt19937_64& random,
                                                         double range_max = 10.0);

}  // namespace omega_slam::test

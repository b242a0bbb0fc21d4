#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/simulation/world.h"

namespace omega_slam::experiments {

/// Where explorations take place, and where in it they begin.
struct Place {
  std::shared_ptr<const simulation::World> world;
  geometry::Pose2 T_world_start;
};

/// Reads a world file, or a map that a robot has drawn. Such a map ends where its robot has not
/// looked; there walls stand in this world, so that what can be explored is what the map shows. It
/// has no start: the robot begins in the middle of it.
/// @throws std::exception if the file cannot be read
[[nodiscard]] Place loadPlace(const std::string& file);

/// Anywhere that the robot can get to from the place's start, and has room; any heading.
/// @param radius [m] of the robot
[[nodiscard]] geometry::Pose2 randomStart(const Place& place, double radius, std::uint64_t seed);

}  // namespace omega_slam::experiments

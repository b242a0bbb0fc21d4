#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/simulation/world.h"

namespace omega_slam::simulation {

/// What `<name>.world.yaml` says about a world. All coordinates are in the frame of its map image.
///
///     map: lab.yaml                  # map_server map beside this file
///     description: "One sentence."
///     start: [1.5, 2.0, 0.0]         # x [m], y [m], heading [rad]
///     route:                         # waypoints for the route follower [m]; may be absent
///       - [3.0, 2.0]
struct WorldFile {
  std::filesystem::path map;  ///< as a path that can be opened
  std::string description;
  geometry::Pose2 start;               ///< `T_world_base` where the robot begins
  std::vector<Eigen::Vector2d> route;  ///< [m]
};

/// A world file and the world that it names.
struct LoadedWorld {
  WorldFile file;
  std::shared_ptr<const World> world;
};

/// Reads strictly: unknown keys and wrong types are errors.
/// @throws std::runtime_error with one sentence that names the file and the key
[[nodiscard]] WorldFile readWorldFile(const std::filesystem::path& path);

/// Reads a world file and its map.
/// @throws std::runtime_error with one sentence that names the file and what is wrong
[[nodiscard]] LoadedWorld loadWorld(const std::filesystem::path& path);

}  // namespace omega_slam::simulation

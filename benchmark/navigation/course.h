#pragma once

#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/navigation/navigator.h"
#include "omega_slam/simulation/people.h"
#include "omega_slam/simulation/world.h"

namespace omega_slam::experiments {

/// Where the experiments on navigation take place: a world, its map, and the robot's navigator.
struct Course {
  std::string name;
  std::shared_ptr<const simulation::World> world;
  grid::OccupancyGrid map;
  navigation::Footprint footprint;

  [[nodiscard]] navigation::Navigator navigator(const navigation::NavigatorConfig& config) const;

  /// A point where the robot fits, on known ground, each as likely as the next.
  [[nodiscard]] Eigen::Vector2d placeToStand(const navigation::Costmap& costmap,
                                             std::mt19937_64& random) const;
  /// A point of the map or a little beyond its edges, whatever is there.
  [[nodiscard]] Eigen::Vector2d anywhere(std::mt19937_64& random) const;

  /// People, each walking between two places by the shortest comfortable way.
  [[nodiscard]] simulation::People people(std::size_t count, std::mt19937_64& random) const;
};

/// @param map_file of map_server; @param urdf the robot's description
/// @throws std::runtime_error with one sentence that names the file and what is wrong
[[nodiscard]] Course loadCourse(const std::filesystem::path& map_file,
                                const std::filesystem::path& urdf);

}  // namespace omega_slam::experiments

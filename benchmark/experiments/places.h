#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <random>
#include <string>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/matching/scan_matcher.h"
#include "omega_slam/simulation/turtlebot.h"
#include "omega_slam/simulation/world.h"

namespace omega_slam::experiments {

/// A world to take scans in.
struct Arena {
  std::string name;
  simulation::World world;
  grid::OccupancyGrid map;  ///< what is known to be free: a world takes unknown cells for empty
};

/// @param name by which results speak of it; @param map_file of map_server
/// @throws std::runtime_error with one sentence that names the file and what is wrong
[[nodiscard]] Arena loadArena(const std::string& name, const std::filesystem::path& map_file);

/// A generator of its own for each thing that is drawn, so that one experiment's draws do not
/// depend on how many another has made.
[[nodiscard]] std::mt19937_64 generatorFor(std::initializer_list<std::uint32_t> key);

/// Uniform over all poses `T_world_base` at which the robot fits: nothing but known free floor
/// below it.
/// @throws std::runtime_error if none was found in a hundred thousand draws
[[nodiscard]] geometry::Pose2 drawFreePose(const Arena& arena, std::mt19937_64& random);

/// Whether the robot fits at a place [m].
[[nodiscard]] bool isFree(const Arena& arena, const Eigen::Vector2d& place);

/// What the TurtleBot's laser sees from a pose of the base at rest, in the base's frame.
[[nodiscard]] matching::View takeScan(const Arena& arena, const geometry::Pose2& T_world_base,
                                      std::mt19937_64& random);

/// The same by a laser without error.
[[nodiscard]] matching::View takePerfectScan(const Arena& arena,
                                             const geometry::Pose2& T_world_base);

/// The standard deviation of the simulated laser's range at a range [m].
[[nodiscard]] double rangeDeviation(double range);

}  // namespace omega_slam::experiments

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/io/scan_source.h"
#include "omega_slam/simulation/world_file.h"

namespace omega_slam::test {

/// A drive along a world's route in the simulator, recorded: what a bag of it would hold, and the
/// truth.
struct SimulatedRun {
  simulation::LoadedWorld world;
  std::vector<io::ScanRecord> records;
  geometry::Trajectory truth;     ///< `T_world_base` at each step of the physics
  geometry::Pose2 T_world_start;  ///< at the first scan's stamp, where the map begins
  int collisions{0};
  bool arrived{false};  ///< at the end of the route
};

/// @param world name of a world that comes with the package, such as "lab"
/// @param seed of the noise of laser and odometry
/// @param noise_factor of the odometry's deviations; 1 is the default Kobuki
/// @param seconds the drive is cut off after so much simulated time
[[nodiscard]] SimulatedRun driveRoute(const std::string& world, std::uint64_t seed,
                                      double noise_factor = 1.0, double seconds = 900.0);

}  // namespace omega_slam::test

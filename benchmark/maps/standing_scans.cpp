#include "maps/standing_scans.h"

#include "omega_slam/simulation/hokuyo.h"

namespace omega_slam::experiments {

std::vector<StandingScan> takeStandingScans(const Site& site, std::size_t count,
                                            std::uint64_t seed) {
  const simulation::TurtleBotConfig robot;
  const geometry::Trajectory path = simulation::driveRoute(site.world, robot, kDrivePatience).truth;
  std::vector<StandingScan> scans;
  for (std::size_t k = 0; k < count; ++k) {
    const geometry::Pose2 T_world_base = path[k * path.size() / count].pose;
    const geometry::Pose2 T_world_laser = T_world_base * robot.T_base_laser;
    simulation::Hokuyo laser(robot.hokuyo, 0.0, seed + k);
    // The last beam is taken well before the mirror has made its turn.
    const double end = 0.99 * laser.scanPeriod();
    scans.push_back(
        {laser.sweep(*site.world.world, {0.0, T_world_laser}, {end, T_world_laser}).value(),
         T_world_base});
  }
  return scans;
}

}  // namespace omega_slam::experiments

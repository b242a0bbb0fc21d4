#include "support/rooms.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::test {

sensing::Sweep sweepInRoom(const Eigen::Vector2d& half, const geometry::Pose2& T_map_base,
                           const geometry::Pose2& T_base_laser, int beams) {
  sensing::Sweep sweep;
  sweep.T_base_laser = T_base_laser;
  sweep.angle_increment = 2.0 * geometry::kPi / beams;
  const geometry::Pose2 T_map_laser = T_map_base * T_base_laser;
  for (int beam = 0; beam < beams; ++beam) {
    const double angle = T_map_laser.theta + beam * sweep.angle_increment;
    const Eigen::Vector2d ray(std::cos(angle), std::sin(angle));
    double range = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 2; ++axis) {
      if (ray[axis] != 0.0) {
        const double wall = ray[axis] > 0.0 ? half[axis] : -half[axis];
        range = std::min(range, (wall - T_map_laser.translation()[axis]) / ray[axis]);
      }
    }
    const Eigen::Vector2d p_map = T_map_laser.translation() + range * ray;
    sweep.beams.push_back({T_map_base.inverse() * p_map, sensing::BeamKind::kReturn});
  }
  return sweep;
}

}  // namespace omega_slam::test

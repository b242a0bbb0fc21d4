#pragma once

#include <vector>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::sensing {

/// One sweep of a 2D laser, as a driver reports it. Beam i points at
/// `angle_min + i * angle_increment` [rad] in the laser's frame (x along the zero ray, REP-138) and
/// is measured at `stamp + i * time_increment` [s]. Ranges follow REP-117.
struct LaserScan {
  double stamp{0.0};            ///< [s], time of beam 0
  double angle_min{0.0};        ///< [rad]
  double angle_increment{0.0};  ///< [rad], negative for a laser that sweeps clockwise
  double time_increment{0.0};   ///< [s] between beams; 0 where all are taken at once
  double range_min{0.0};        ///< [m]
  double range_max{0.0};        ///< [m]
  std::vector<float> ranges;    ///< [m]
};

/// How the laser sits on the robot.
struct LaserMount {
  geometry::Pose2 T_base_laser;
  bool upside_down{false};  ///< mounted with its z axis downwards: beams sweep the other way
};

}  // namespace omega_slam::sensing

#pragma once

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::graph {

/// Where the robot truly was at one time, seen from where it was at another: what is known of a
/// drive when its trajectory as a whole is not (Kuemmerle et al., "On measuring the accuracy of
/// SLAM algorithms", Autonomous Robots 27, 2009).
struct Relation {
  double from_stamp{0.0};     ///< [s]
  double to_stamp{0.0};       ///< [s]
  geometry::Pose2 T_from_to;  ///< the true one
};

}  // namespace omega_slam::graph

#pragma once

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::motion {

/// Motion of a differential drive while both wheels turn steadily.
struct Arc {
  double length{0.0};  ///< [m] along the path, negative backwards
  double turn{0.0};    ///< [rad]

  [[nodiscard]] geometry::Pose2 toMotion() const;  ///< `T_start_end`
};

}  // namespace omega_slam::motion

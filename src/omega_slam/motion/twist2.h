#pragma once

namespace omega_slam::motion {

/// Velocity of the base in its own frame.
struct Twist2 {
  double linear{0.0};   ///< [m/s] forward
  double angular{0.0};  ///< [rad/s] counter-clockwise
};

}  // namespace omega_slam::motion

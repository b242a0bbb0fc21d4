#include "omega_slam/geometry/angle.h"

#include <cmath>

namespace omega_slam::geometry {

double normalizeAngle(double angle) {
  if (angle >= -kPi && angle < kPi) {
    return angle;  // as most are
  }
  const double wrapped = angle - 2.0 * kPi * std::floor((angle + kPi) / (2.0 * kPi));
  // Rounding may carry a value just below -pi up to exactly pi.
  return wrapped >= kPi ? wrapped - 2.0 * kPi : wrapped;
}

double angleDifference(double to, double from) { return normalizeAngle(to - from); }

}  // namespace omega_slam::geometry

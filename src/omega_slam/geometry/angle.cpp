#include "omega_slam/geometry/angle.h"

#include <cmath>

namespace omega_slam::geometry {

double normalizeAngle(double angle) {
  if (angle >= -kPi && angle < kPi) {
    return angle;  // as most are
  }
  // Exact, however many turns; pi itself is left to be wrapped.
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped >= kPi ? wrapped - 2.0 * kPi : wrapped;
}

double angleDifference(double to, double from) { return normalizeAngle(to - from); }

}  // namespace omega_slam::geometry

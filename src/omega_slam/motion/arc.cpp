#include "omega_slam/motion/arc.h"

#include <cmath>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::motion {

geometry::Pose2 Arc::toMotion() const {
  // A chord of the circle: it points half the turn to the side and is shorter than the arc by
  // sin(h) / h. The series serves where the division would lose its digits.
  const double half = 0.5 * turn;
  const double shortening = std::abs(half) < 1e-4 ? 1.0 - half * half / 6.0 : std::sin(half) / half;
  const double chord = length * shortening;
  return {chord * std::cos(half), chord * std::sin(half), geometry::normalizeAngle(turn)};
}

}  // namespace omega_slam::motion

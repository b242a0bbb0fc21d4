#include "omega_slam/exploration/information_gain.h"

#include <cmath>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::exploration {

double expectedGain(const MapView& map, const Eigen::Vector2d& position, double range) {
  constexpr int kRays = 72;
  constexpr double kAngle = 2.0 * geometry::kPi / kRays;
  const double step = map.geometry().resolution;
  double area = 0.0;
  for (int i = 0; i < kRays; ++i) {
    const Eigen::Vector2d direction(std::cos(i * kAngle), std::sin(i * kAngle));
    for (double distance = step; distance <= range; distance += step) {
      const CellState state = map.at(map.cellAt(position + distance * direction));
      if (state == CellState::kOccupied) {
        break;
      }
      if (state == CellState::kUnknown) {
        area += kAngle * distance * step;  // a piece of the ray's sector
      }
    }
  }
  return area;
}

}  // namespace omega_slam::exploration

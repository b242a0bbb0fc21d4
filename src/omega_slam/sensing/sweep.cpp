#include "omega_slam/sensing/sweep.h"

namespace omega_slam::sensing {

std::vector<Eigen::Vector2d> Sweep::returns() const {
  std::vector<Eigen::Vector2d> points;
  points.reserve(beams.size());
  for (const Beam& beam : beams) {
    if (beam.kind == BeamKind::kReturn) {
      points.push_back(beam.end);
    }
  }
  return points;
}

}  // namespace omega_slam::sensing

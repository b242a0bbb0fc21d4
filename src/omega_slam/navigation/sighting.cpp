#include "omega_slam/navigation/sighting.h"

namespace omega_slam::navigation {

Sighting sightingFrom(const sensing::Sweep& sweep) {
  Sighting sighting;
  sighting.stamp = sweep.stamp;
  sighting.origin = sweep.T_base_laser.translation();
  for (const sensing::Beam& beam : sweep.beams) {
    if (beam.kind == sensing::BeamKind::kReturn) {
      sighting.returns.push_back(beam.end);
    } else if (beam.kind == sensing::BeamKind::kNoReturn) {
      sighting.clear.push_back(beam.end);
    }
  }
  return sighting;
}

}  // namespace omega_slam::navigation

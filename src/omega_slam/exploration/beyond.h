#pragma once

#include <cstdint>
#include <vector>

#include "omega_slam/exploration/frontier.h"
#include "omega_slam/exploration/travel_field.h"

namespace omega_slam::exploration {

/// What a robot has not come to yet: all that is unknown, and floor that was seen but that no known
/// way leads to. Looks at the map, which must outlive it.
class Beyond {
 public:
  /// @param travel from where the robot is; @param radius [m] of the robot: floor beside where its
  /// middle gets to has been come to
  Beyond(const MapView& map, const TravelField& travel, double radius);

  /// [m^2] that begins at a frontier and hangs together, by edges of cells. A nook behind a
  /// cupboard that is known all round is small, and nothing larger can come of looking there;
  /// behind a door it is as large as `reach` allows, and so is a shadow across the only way to
  /// what was seen from afar.
  /// @param reach [m] from the frontier's centroid, as far as area counts; time grows with its
  /// square
  [[nodiscard]] double areaBehind(const Frontier& frontier, double reach) const;

 private:
  [[nodiscard]] bool contains(const Cell& cell) const;

  MapView map_;
  std::vector<std::uint8_t> come_to_;  ///< row-major, one byte a cell of the map
};

}  // namespace omega_slam::exploration

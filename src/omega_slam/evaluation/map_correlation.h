#pragma once

#include <optional>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::evaluation {

struct MapCorrelationOptions {
  int headings{180};   ///< tried around the circle in the coarse search
  int candidates{12};  ///< of them, those that are refined

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// The alignment at which the maps correlate most.
struct MapCorrelation {
  geometry::Pose2 T_truth_map;  ///< the built map's frame in the true map's frame
  double value{0.0};            ///< what was maximised: comparable for the same pair of maps only
};

/// Lays a built map on the true one by correlation. Both are fields: positive in walls, negative in
/// open cells, so that both weigh the same, 0 in the unknown. Walls on walls and open on open gain,
/// walls on open lose. For each of so many headings all translations at once are tried by Fourier
/// transform, on coarse cells; the best are refined by a compass search (Kolda, Lewis, Torczon,
/// SIAM Review 2003) on finer and finer fields, to a fiftieth of a cell.
///
/// It always answers as long as both maps have walls, also where they have nothing in common: the
/// resemblance at the place that it finds tells. Deterministic. O(h n log n) for n coarse cells and
/// h headings: some tenths of a second for a building.
/// @return nothing if a map has no walls
/// @throws std::invalid_argument for options that are not valid
[[nodiscard]] std::optional<MapCorrelation> alignByCorrelation(
    const grid::OccupancyGrid& built, const grid::OccupancyGrid& truth,
    const MapCorrelationOptions& options = {});

}  // namespace omega_slam::evaluation

#pragma once

#include <string>
#include <vector>

#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::test {

/// A map drawn in the source, top row first: '#' occupied, '?' unknown, anything else free. Its
/// lower left corner is the origin.
/// @param rows of equal length; @param resolution [m] of a cell
/// @param cells each character stands for so many by so many of them
[[nodiscard]] grid::OccupancyGrid drawnMap(const std::vector<std::string>& rows,
                                           double resolution = 1.0, int cells = 1);

}  // namespace omega_slam::test

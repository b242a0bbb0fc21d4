#pragma once

#include <memory>
#include <string>
#include <vector>

#include "omega_slam/simulation/world.h"

namespace omega_slam::test {

/// A world drawn in the source, top row first: '#' wall, 'd' dark, 'g' glass, anything else empty.
/// Its lower left corner is the origin.
/// @param rows of equal length; @param resolution [m] edge of a character
[[nodiscard]] std::shared_ptr<const simulation::World> drawnWorld(
    const std::vector<std::string>& rows, double resolution);

/// An empty square room around the origin, walls one cell thick outside of it.
/// @param half [m] from the origin to each wall; a multiple of the resolution
[[nodiscard]] std::shared_ptr<const simulation::World> emptyRoom(double half,
                                                                 double resolution = 0.05);

}  // namespace omega_slam::test

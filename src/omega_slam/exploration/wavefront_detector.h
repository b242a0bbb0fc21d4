#pragma once

#include <Eigen/Core>
#include <vector>

#include "omega_slam/exploration/frontier.h"

namespace omega_slam::exploration {

/// Wavefront frontier detection (the paper, section 4.2; Keidar and Kaminka, "Efficient Frontier
/// Detection for Robot Exploration", IJRR 33(2), 2014): a breadth-first search over open cells,
/// which looks at each once and gathers the unknown cells right next to them. Cells beyond the
/// map's edge count as unknown.
///
/// Deviations: open cells are connected by edges only, so that nothing leaks through the corners of
/// a slanting wall; the cells are parted into frontiers in the end, and not by a second search
/// within the first, which comes to the same.
///
/// @param start [m] map frame, the robot; the search begins at the open cells nearest to it, as far
/// as `reach` [m], because the floor below the robot may not have been seen. All of them begin it.
/// @return frontiers without ids; none if there is no open cell near the start. Time is linear in
/// the number of open cells.
[[nodiscard]] std::vector<Frontier> detectByWavefront(const MapView& map,
                                                      const Eigen::Vector2d& start, double reach);

}  // namespace omega_slam::exploration

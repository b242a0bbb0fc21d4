#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "omega_slam/exploration/map_view.h"

namespace omega_slam::exploration {

/// Names a frontier for as long as some of it is there. 0: none.
using FrontierId = std::uint64_t;

/// A connected set (by edges or corners) of frontier cells.
struct Frontier {
  FrontierId id{0};
  std::vector<Cell> cells;             ///< by rows, then columns
  Eigen::Vector2d centroid{0.0, 0.0};  ///< [m] map frame: centre of one of the cells, the one
                                       ///< nearest to the mean of all
  double size{0.0};                    ///< [m] as many edges of a cell as there are cells
  Eigen::AlignedBox2i box;             ///< around the cells, both corners inclusive
};

/// Whether `a` comes before `b` by rows, then columns.
[[nodiscard]] inline bool comesBefore(const Cell& a, const Cell& b) {
  return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
}

/// Parts a set of cells into frontiers, without ids, in the order of their first cells.
[[nodiscard]] std::vector<Frontier> clusterFrontiers(std::vector<Cell> cells, const MapView& map);

}  // namespace omega_slam::exploration

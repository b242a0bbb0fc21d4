#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/sensing/sweep.h"

namespace omega_slam::mapping {

struct OccupancyMapperConfig {
  double resolution{0.05};  ///< [m]
  double max_range{0.0};  ///< [m] Returns farther away are drawn as free up to there; 0: no limit.
  double occupied_threshold{
      0.5};                 ///< share of hits among hits and misses from which on a cell is a wall
  int min_observations{1};  ///< cells that fewer beams have touched stay unknown
  double max_extent{2000.0};  ///< [m] a map wider or higher than this is refused

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// Beam-based occupancy grid (the paper, section 6.3; Probabilistic Robotics, chapter 9): cells
/// along a beam are seen free, the cell at its end is seen occupied, and both are counted. The grid
/// grows as needed.
class OccupancyMapper {
 public:
  explicit OccupancyMapper(
      const OccupancyMapperConfig& config = {});  ///< @throws std::invalid_argument

  /// Draws one sweep. @return an empty string, or why it was refused (pose not finite, map too
  /// large)
  std::string add(const sensing::Sweep& sweep, const geometry::Pose2& T_map_base);

  /// The map so far, strictly {-1, 0, 100}; an empty grid (0 x 0) if nothing was drawn.
  [[nodiscard]] grid::OccupancyGrid render() const;

  void clear();

 private:
  struct Counts {
    std::uint16_t hits{0};
    std::uint16_t misses{0};
  };
  OccupancyMapperConfig config_;
  grid::GridGeometry geometry_;
  std::vector<Counts> counts_;
};

}  // namespace omega_slam::mapping

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/mapping/cell_counts.h"
#include "omega_slam/mapping/sweep_renderer.h"
#include "omega_slam/sensing/sweep.h"

namespace omega_slam::mapping {

struct OccupancyMapperConfig {
  double resolution{0.05};  ///< [m]
  double max_range{0.0};  ///< [m] Returns farther away are drawn as free up to there; 0: no limit.
  double occupied_threshold{
      0.5};                 ///< share of hits among hits and misses from which on a cell is a wall
  int min_observations{1};  ///< cells that fewer sweeps have touched stay unknown
  double max_extent{2000.0};  ///< [m] a map wider or higher than this is refused
  RendererConfig renderer;    ///< how beams become cells

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// Beam-based occupancy grid (the paper, section 6.3; Probabilistic Robotics, chapter 9): cells
/// along a beam are seen free, the cell at its end is seen occupied, and both are counted.
///
/// A sweep counts once in a cell: a hit if any of its beams ends there, else a miss if any passes
/// through. Many beams of one sweep cross the cells near the laser, and they are no independent
/// witnesses; and where a wall is seen at a grazing angle, the cell in which one beam ends is
/// crossed by its neighbours on their way farther along the wall. Were each counted, such walls
/// would be erased by the very sweep that has seen them.
///
/// The grid grows as needed, by a margin each time so that growing costs little in the sum. Cells
/// are aligned with the origin of the map frame, so that the map does not depend on the order in
/// which sweeps arrive. Not thread-safe: one owner calls it.
class OccupancyMapper {
 public:
  explicit OccupancyMapper(
      const OccupancyMapperConfig& config = {});  ///< @throws std::invalid_argument

  /// The largest map that is drawn, whatever the extent allows: at 5 cm 580 m by 580 m.
  static constexpr std::uint64_t kMaxCells = std::uint64_t{1} << 27U;

  /// Draws one sweep.
  /// @return an empty string, or why it was refused (pose or beam not finite, map too large); then
  /// nothing has changed
  std::string add(const sensing::Sweep& sweep, const geometry::Pose2& T_map_base);

  /// The map so far, strictly {-1, 0, 100}, cropped to what was touched; an empty grid (0 x 0) if
  /// nothing was drawn.
  [[nodiscard]] grid::OccupancyGrid render() const;

  void clear();

 private:
  /// Cells by their number counted from the origin of the map, both corners inclusive.
  using Box = Eigen::AlignedBox<int, 2>;
  [[nodiscard]] std::string whyTooLarge(const Box& box) const;
  void growTo(const Box& needed);
  [[nodiscard]] std::int8_t verdict(const CellCounts& counts) const;
  void count();

  OccupancyMapperConfig config_;
  Box touched_;  ///< what sweeps have drawn on
  Box stored_;   ///< what there is memory for: touched_ and a margin
  std::vector<CellCounts> counts_;
  std::unique_ptr<const SweepRenderer> renderer_;
  SweepRays rays_;    ///< of the sweep being drawn; kept to spare allocations
  SweepCells cells_;  ///< likewise
};

}  // namespace omega_slam::mapping

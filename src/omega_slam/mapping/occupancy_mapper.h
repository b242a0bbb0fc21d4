#pragma once

#include <memory>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/mapping/cell_counts.h"
#include "omega_slam/mapping/count_map.h"
#include "omega_slam/mapping/map_snapshot.h"
#include "omega_slam/mapping/people_filter.h"
#include "omega_slam/mapping/sweep_renderer.h"
#include "omega_slam/sensing/sweep.h"

namespace omega_slam::mapping {

struct OccupancyMapperConfig {
  double resolution{0.05};  ///< [m]
  double max_range{0.0};  ///< [m] Returns farther away are drawn as free up to there; 0: no limit.
  double max_extent{2000.0};  ///< [m] a map wider or higher than this is refused
  RendererConfig renderer;    ///< how beams become cells
  CellRules rules;            ///< how counts become free cells and walls
  bool forget_people{true};   ///< whether cells that were seen through at last lose their walls

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// A sweep where it was taken. Sweeps never change once made, so they are shared, not copied.
struct PlacedSweep {
  SweepId id{0};
  std::shared_ptr<const sensing::Sweep> sweep;
  geometry::Pose2 T_map_base;
};

/// A sweep as it is in the map.
struct DrawnSweep {
  PlacedSweep placed;
  double reach{0.0};  ///< [m] from the robot's base to the farthest end of a beam
};

/// Occupancy grid of sweeps (the paper, section 6; Probabilistic Robotics, chapter 9): cells that
/// beams pass are seen free, cells that they end in are seen occupied, and both are counted.
///
/// A sweep counts once in a cell: a hit if any of its beams ends there, else a miss if any passes
/// through. Many beams of one sweep cross the cells near the laser, and they are no independent
/// witnesses; and where a wall is seen at a grazing angle, the cell in which one beam ends is
/// crossed by its neighbours on their way farther along the wall. Were each counted, such walls
/// would be erased by the very sweep that has seen them.
///
/// What was put in can be taken out, and then the map is exactly as if it had never been in. The
/// map depends on the sweeps that are in it, their poses and their numbers, and on nothing else;
/// cells are aligned with the origin of the map frame. Not thread-safe: one owner calls it, others
/// look at snapshots.
class OccupancyMapper {
 public:
  explicit OccupancyMapper(
      const OccupancyMapperConfig& config = {});  ///< @throws std::invalid_argument

  /// The largest map that is drawn, whatever the extent allows: at 5 cm 580 m by 580 m.
  static constexpr std::uint64_t kMaxCells = std::uint64_t{1} << 27U;

  /// Draws a sweep. One of that number that is in the map already is taken out first: it has moved.
  /// @return an empty string, or why it was refused (pose or beam not finite, map too large); then
  /// no sweep of that number is in the map
  std::string put(const PlacedSweep& placed);
  /// Draws a sweep under the next free number.
  std::string add(const sensing::Sweep& sweep, const geometry::Pose2& T_map_base);
  /// Takes a sweep out. Nothing happens if there is none of that number.
  void takeOut(SweepId id);
  void clear();

  /// The sweeps that are in the map, by number.
  [[nodiscard]] const std::vector<DrawnSweep>& drawn() const { return drawn_; }
  [[nodiscard]] const OccupancyMapperConfig& config() const { return config_; }

  /// The map now. Costs as much as copying a pointer for each tile.
  [[nodiscard]] MapSnapshot snapshot();

  /// The map so far, strictly {-1, 0, 100}, cropped to what was seen; an empty grid (0 x 0) if
  /// nothing was drawn.
  [[nodiscard]] grid::OccupancyGrid render();

 private:
  [[nodiscard]] std::vector<DrawnSweep>::iterator find(SweepId id);
  void subtract(const PlacedSweep& placed);
  [[nodiscard]] std::string draw(const PlacedSweep& placed);
  [[nodiscard]] std::string whyTooLarge(const CellBox& sweep);
  [[nodiscard]] double reachFrom(const geometry::Pose2& T_map_base) const;

  OccupancyMapperConfig config_;
  std::unique_ptr<const SweepRenderer> renderer_;
  std::vector<DrawnSweep> drawn_;
  CountMap counts_;
  PeopleFilter people_;
  CellBox bounds_;    ///< around all that is in the map, and perhaps what was
  SweepRays rays_;    ///< of the sweep being drawn; kept to spare allocations
  SweepCells cells_;  ///< likewise
};

}  // namespace omega_slam::mapping

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::evaluation {

struct ResemblanceOptions {
  /// [cells of the map looked in] A wall counts as found in its place if one lies at most so many
  /// cells away, along each axis. A wall is a line: half a cell of misalignment would move all of
  /// it off itself. Open space is an area and gets no tolerance.
  int wall_tolerance{1};

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// How a built map resembles the true one, cell by cell (the paper, section 7.3). Cells are walls
/// from 65 up and open from 0 to 25, as map_saver has it; anything else is unknown.
struct Resemblance {
  std::size_t walls_right{0};  ///< built wall cells with a true wall in their place
  std::size_t walls_wrong{0};  ///< built wall cells without
  std::size_t open_right{0};   ///< built open cells that the robot can truly reach
  std::size_t open_wrong{0};   ///< built open cells in a wall, outside, or otherwise inaccessible

  std::size_t walls_to_find{0};  ///< true wall cells that border on reachable space
  std::size_t walls_found{0};    ///< of those, the ones with a built wall in their place
  std::size_t open_to_find{0};   ///< true open cells that can be reached from the start
  std::size_t open_found{0};     ///< of those, the ones built open
  std::size_t open_seen{0};      ///< of those, the ones not unknown in the built map

  [[nodiscard]] double score() const;     ///< the resemblance: share of built cells right, [0, 1]
  [[nodiscard]] double balanced() const;  ///< mean of the share of walls and the share of open
  [[nodiscard]] double wallPrecision() const;
  [[nodiscard]] double wallRecall() const;
  [[nodiscard]] double openPrecision() const;
  [[nodiscard]] double openRecall() const;
  [[nodiscard]] double coverage() const;  ///< share of reachable space that was seen
};

/// Where to compare.
struct MapPlacement {
  geometry::Pose2 T_truth_map;  ///< the built map's frame in the true map's frame
  /// [m] Where the robot started, in the true map's frame: what is connected with it can be
  /// reached. Without it, the largest open space of the true map is what can be reached.
  std::optional<Eigen::Vector2d> start_truth;
};

/// What a cell of the one map is found to be in the other.
enum class Verdict : std::uint8_t {
  kNone,        ///< not judged: unknown, or in the true map neither reachable nor bordering on that
  kWallRight,   ///< a wall in both
  kWallWrong,   ///< built, but there is none
  kWallMissed,  ///< there is one, but it was not built
  kOpenRight,   ///< open in both
  kOpenWrong,   ///< built open, but a wall or out of reach
  kOpenMissed,  ///< reachable, but built as a wall
  kOpenUnseen   ///< reachable, but unknown or outside of the built map
};

/// A verdict for each cell of both maps, and their sums.
struct MapComparison {
  std::vector<Verdict> built;  ///< cells as in the built map
  std::vector<Verdict> truth;  ///< cells as in the true map
  Resemblance resemblance;
};

/// Compares a built map with the true one. Resolutions may differ: each cell of the one is looked
/// up by its centre in the other. If a start is given that is not in open space of the true map,
/// nothing can be reached and all open cells are wrong. Linear in the cells of both maps.
/// @throws std::invalid_argument for options that are not valid
[[nodiscard]] MapComparison judgeMaps(const grid::OccupancyGrid& built,
                                      const grid::OccupancyGrid& truth,
                                      const MapPlacement& placement,
                                      const ResemblanceOptions& options = {});

/// The sums alone.
[[nodiscard]] inline Resemblance compareMaps(const grid::OccupancyGrid& built,
                                             const grid::OccupancyGrid& truth,
                                             const MapPlacement& placement,
                                             const ResemblanceOptions& options = {}) {
  return judgeMaps(built, truth, placement, options).resemblance;
}

}  // namespace omega_slam::evaluation

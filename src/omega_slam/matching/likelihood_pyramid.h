#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "omega_slam/grid/grid_geometry.h"
#include "omega_slam/matching/tiled_grid.h"

namespace omega_slam::matching {

/// How likely a return is at each place, given where surfaces are; and, on coarser levels, at the
/// likeliest place nearby: the precomputed grids of Hess et al. 2016 ("Real-time loop closure in 2D
/// lidar SLAM", ICRA, section V-B). Theirs have the maximum over a square for each cell on each
/// level; here a level has one value for a block of cells, as in Olson 2009, which takes a fraction
/// of the memory, and is drawn from the surfaces directly.
///
/// The likelihood of a place d cells from the nearest surface is 1 - (d / reach)^2, and nothing
/// beyond `reach`: what a point adds to the confidence of a match (match_quality.h). It is a whole
/// number of kFull-ths, so that sums are exact.
class LikelihoodPyramid {
 public:
  static constexpr int kFull = 255;

  /// O(surfaces * reach^2).
  /// @param surfaces cells on surfaces
  /// @param reach    cells, > 0
  /// @param levels   >= 1
  LikelihoodPyramid(const std::vector<grid::Cell>& surfaces, int reach, int levels);

  [[nodiscard]] int levels() const { return static_cast<int>(levels_.size()); }

  /// A level's blocks have 2^shift cells on each side.
  [[nodiscard]] static int blockShift(int level) { return level > 0 ? level - 1 : 0; }

  /// How far around a block a level looks for the likeliest place [cells].
  [[nodiscard]] static int slack(int level) { return (1 << level) - 1; }

  /// The greatest likelihood, in kFull-ths, of the cells of a block and of those within the level's
  /// slack of it. Level 0 has blocks of one cell and no slack.
  /// @param block_x, block_y a cell's indices divided by the block's side, rounded down
  [[nodiscard]] int at(int level, int block_x, int block_y) const {
    return levels_[static_cast<std::size_t>(level)].at(block_x, block_y);
  }

  /// The same for four blocks, `step` < TiledGrid::kSide blocks apart: as TiledGrid::atFour.
  [[nodiscard]] std::array<std::uint8_t, 4> atFour(int level, const grid::Cell& block,
                                                   int step) const {
    return levels_[static_cast<std::size_t>(level)].atFour(block.x(), block.y(), step);
  }

 private:
  std::vector<TiledGrid<std::uint8_t>> levels_;
};

}  // namespace omega_slam::matching

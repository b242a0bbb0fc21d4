#pragma once

#include "omega_slam/mapping/sweep_renderer.h"

namespace omega_slam::mapping {

/// Beam-based map generation (the paper, section 6.3): cells along a beam are free, the cell at its
/// end is occupied if something was hit there.
///
/// Deviation: a beam may have a width. Where it is wider than a cell, it clears the triangle that
/// it covers, and occupies all cells across its end. In the cells before the end that the range's
/// noise makes doubtful, nothing is free.
class BeamRenderer : public SweepRenderer {
 public:
  /// @param range_noise [m] standard deviation
  /// @param width [rad] full opening angle of a beam
  BeamRenderer(double range_noise, double width) : range_noise_(range_noise), width_(width) {}

  void render(const SweepRays& rays, SweepCells& cells) const override;

 private:
  void renderWide(const SweepRays& rays, const Ray& ray, SweepCells& cells) const;

  double range_noise_;
  double width_;
};

/// Where the stretch of a ray ends that is certainly free, [cells]: two standard deviations of the
/// range before a hit, at the end of a ray that hits nothing. Never behind the start.
[[nodiscard]] Eigen::Vector2d freeEnd(const SweepRays& rays, const Ray& ray, double range_noise);

/// Marks the cells of a line without width: free up to `free_end`, the last cell of a hit occupied.
/// @param skipped so much of it that is free need not be marked: see grid::traverseRows()
void renderLine(const SweepRays& rays, const Ray& ray, const Eigen::Vector2d& free_end,
                SweepCells& cells, int skipped = 0);

}  // namespace omega_slam::mapping

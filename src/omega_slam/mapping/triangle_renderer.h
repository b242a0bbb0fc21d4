#pragma once

#include "omega_slam/mapping/sweep_renderer.h"

namespace omega_slam::mapping {

/// Triangulation-based map generation (the paper, section 6.2): between neighbouring beams the
/// triangle of the laser and both ends is free, and the cells that join the ends are occupied
/// unless a beam has hit nothing.
///
/// Deviation, unless `join_all` is set: an end that lies far behind its neighbour's, as in an open
/// door, belongs to another surface. Neighbours have seen one surface only if
///   - they are neighbours in the sweep: beams between that say nothing leave a gap,
///   - the angle between them is not above 1.5 times the sweep's `angle_increment`,
///   - their ranges differ by `max_range_gap` at most.
/// Where one of these fails nothing joins the ends. The first two leave nothing known between the
/// beams; if only the third does, the triangle reaches as far as the nearer of both. What is left
/// of a beam is drawn as a line, as beams at the edge of the sweep are.
class TriangleRenderer : public SweepRenderer {
 public:
  /// @param range_noise [m] standard deviation
  TriangleRenderer(double range_noise, const TriangleConfig& config)
      : range_noise_(range_noise), config_(config) {}

  void render(const SweepRays& rays, SweepCells& cells) const override;

 private:
  [[nodiscard]] bool isOneSurface(const SweepRays& rays, const Ray& a, const Ray& b) const;
  bool renderBetween(const SweepRays& rays, const Ray& a, const Ray& b, SweepCells& cells) const;

  double range_noise_;
  TriangleConfig config_;
};

}  // namespace omega_slam::mapping

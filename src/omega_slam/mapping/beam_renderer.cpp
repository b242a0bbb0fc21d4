#include "omega_slam/mapping/beam_renderer.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "omega_slam/grid/ray_traversal.h"
#include "omega_slam/mapping/ray_fan.h"
#include "omega_slam/mapping/triangle_fill.h"

namespace omega_slam::mapping {

Eigen::Vector2d freeEnd(const SweepRays& rays, const Ray& ray, double range_noise) {
  constexpr double kDeviations = 2.0;
  const double doubtful = kDeviations * range_noise / rays.resolution;
  if (!ray.is_hit || doubtful <= 0.0) {
    return ray.end;
  }
  const double share = ray.length > doubtful ? 1.0 - doubtful / ray.length : 0.0;
  return rays.start + share * (ray.end - rays.start);
}

void renderLine(const SweepRays& rays, const Ray& ray, const Eigen::Vector2d& free_end,
                SweepCells& cells, int skipped) {
  grid::traverseRows(rays.start, free_end, skipped, [&cells](int y, int first_x, int last_x) {
    cells.markFreeRow(y, first_x, last_x);
  });
  if (ray.is_hit) {
    cells.markOccupied(cellOf(ray.end));
  }
}

void BeamRenderer::render(const SweepRays& rays, SweepCells& cells) const {
  cells.begin(rays.box);
  std::vector<Eigen::Vector2d> free_ends;
  free_ends.reserve(rays.rays.size());
  for (const Ray& ray : rays.rays) {
    free_ends.push_back(freeEnd(rays, ray, range_noise_));
  }
  const RayFan fan(rays.start, free_ends);
  for (std::size_t k = 0; k < rays.rays.size(); ++k) {
    const Ray& ray = rays.rays[k];
    renderLine(rays, ray, free_ends[k], cells, fan.coveredBorders(k));
    if (width_ * ray.length > 1.0) {
      renderWide(rays, ray, cells);
    }
  }
}

void BeamRenderer::renderWide(const SweepRays& rays, const Ray& ray, SweepCells& cells) const {
  const Eigen::Rotation2Dd half(width_ / 2.0);
  const Eigen::Vector2d way = ray.end - rays.start;
  const Eigen::Vector2d free_way = freeEnd(rays, ray, range_noise_) - rays.start;
  fillTriangle({rays.start, rays.start + half * free_way, rays.start + half.inverse() * free_way},
               cells);
  if (ray.is_hit) {
    grid::traverseCells(rays.start + half * way, rays.start + half.inverse() * way,
                        [&cells](const auto& cell) { cells.markOccupied(cell); });
  }
}

}  // namespace omega_slam::mapping

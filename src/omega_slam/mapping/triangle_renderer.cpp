#include "omega_slam/mapping/triangle_renderer.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/grid/ray_traversal.h"
#include "omega_slam/mapping/beam_renderer.h"
#include "omega_slam/mapping/triangle_fill.h"

namespace omega_slam::mapping {
namespace {

/// Whether so little angle lies between two rays that they are neighbours.
bool areNeighbours(const SweepRays& rays, const Ray& a, const Ray& b) {
  constexpr double kSlack = 1.5;  // a sweep made on the move is not spaced evenly
  if (b.beam != a.beam + 1) {
    return false;
  }
  const Eigen::Vector2d to_a = a.end - rays.start;
  const Eigen::Vector2d to_b = b.end - rays.start;
  const double angle =
      std::abs(std::atan2(to_a.x() * to_b.y() - to_a.y() * to_b.x(), to_a.dot(to_b)));
  return angle <= kSlack * rays.angle_increment;
}

/// The point of a way from the start that is `length` away, or its end.
Eigen::Vector2d cutAt(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double length) {
  const double whole = (end - start).norm();
  return whole > length ? Eigen::Vector2d(start + (end - start) * (length / whole)) : end;
}

}  // namespace

bool TriangleRenderer::isOneSurface(const SweepRays& rays, const Ray& a, const Ray& b) const {
  return config_.join_all ||
         std::abs(a.length - b.length) * rays.resolution <= config_.max_range_gap;
}

void TriangleRenderer::render(const SweepRays& rays, SweepCells& cells) const {
  cells.begin(rays.box);
  bool is_covered = false;  // by a whole triangle on the side that the sweep comes from
  for (std::size_t k = 0; k < rays.rays.size(); ++k) {
    const Ray& ray = rays.rays[k];
    const bool covers =
        k + 1 < rays.rays.size() && renderBetween(rays, ray, rays.rays[k + 1], cells);
    if (!config_.join_all && !(is_covered && covers)) {
      renderLine(rays, ray, freeEnd(rays, ray, range_noise_), cells);
    } else if (ray.is_hit) {
      cells.markOccupied(cellOf(ray.end));
    }
    is_covered = covers;
  }
}

/// @return whether all between the rays is filled
bool TriangleRenderer::renderBetween(const SweepRays& rays, const Ray& a, const Ray& b,
                                     SweepCells& cells) const {
  if (!config_.join_all && !areNeighbours(rays, a, b)) {
    return false;
  }
  Eigen::Vector2d end_a = freeEnd(rays, a, range_noise_);
  Eigen::Vector2d end_b = freeEnd(rays, b, range_noise_);
  const bool is_one_surface = isOneSurface(rays, a, b);
  if (!is_one_surface) {
    const double nearer = std::min((end_a - rays.start).norm(), (end_b - rays.start).norm());
    end_a = cutAt(rays.start, end_a, nearer);
    end_b = cutAt(rays.start, end_b, nearer);
  } else if (a.is_hit && b.is_hit) {
    grid::traverseCells(a.end, b.end, [&cells](const auto& cell) { cells.markOccupied(cell); });
  }
  fillTriangle({rays.start, end_a, end_b}, cells);
  return is_one_surface;
}

}  // namespace omega_slam::mapping

#include "omega_slam/mapping/sweep_rays.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace omega_slam::mapping {
namespace {

/// Cell numbers beyond this are refused: sums and differences of them must fit into an int.
constexpr double kFarthestCell = 1 << 29;

CellBox boxAround(const SweepRays& rays) {
  CellBox box;
  for (const Ray& ray : rays.rays) {
    box.extend(cellOf(ray.end));
  }
  if (!rays.rays.empty()) {
    box.extend(cellOf(rays.start));
  }
  return box;
}

}  // namespace

std::string placeRays(const sensing::Sweep& sweep, const geometry::Pose2& T_map_base,
                      double resolution, double max_range, SweepRays& rays) {
  rays.rays.clear();
  rays.box.setEmpty();
  rays.resolution = resolution;
  rays.angle_increment = sweep.angle_increment;
  const geometry::Pose2 T_map_laser = T_map_base * sweep.T_base_laser;
  if (!T_map_laser.isFinite()) {
    return "the pose of the laser in the map is not finite";
  }
  rays.start = T_map_laser.translation() / resolution;
  // From the base frame to cells, seen from the start of the rays.
  const Eigen::Matrix2d R_map_base =
      Eigen::Rotation2Dd(T_map_base.theta).toRotationMatrix() / resolution;
  const Eigen::Vector2d base = T_map_base.translation() / resolution - rays.start;
  double farthest = rays.start.cwiseAbs().maxCoeff();
  const double longest =
      max_range > 0.0 ? max_range / resolution : std::numeric_limits<double>::infinity();
  for (std::size_t beam = 0; beam < sweep.beams.size(); ++beam) {
    const sensing::Beam& seen = sweep.beams[beam];
    if (seen.kind == sensing::BeamKind::kUnknown) {
      continue;
    }
    const Eigen::Vector2d whole = base + R_map_base * seen.end;
    const double length = whole.norm();
    if (!std::isfinite(length)) {
      return "the end of a beam is not finite";
    }
    const bool is_whole = length <= longest;
    const Eigen::Vector2d end =
        rays.start + (is_whole ? whole : Eigen::Vector2d(whole * (longest / length)));
    farthest = std::max(farthest, end.cwiseAbs().maxCoeff());
    rays.rays.push_back({end, std::min(length, longest),
                         is_whole && seen.kind == sensing::BeamKind::kReturn, beam});
  }
  if (!(farthest <= kFarthestCell)) {
    return fmt::format("it reaches {:.6g} m away from the origin of the map",
                       farthest * resolution);
  }
  rays.box = boxAround(rays);
  return {};
}

}  // namespace omega_slam::mapping

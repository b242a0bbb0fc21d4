#include "omega_slam/simulation/surroundings.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::simulation {
namespace {

/// Length of a ray up to where it enters a disc; 0 from inside of it.
std::optional<double> rangeOf(const Disc& disc, const Eigen::Vector2d& origin,
                              const Eigen::Vector2d& direction) {
  const Eigen::Vector2d to_center = disc.center - origin;
  const double square = to_center.squaredNorm() - disc.radius * disc.radius;
  if (square <= 0.0) {
    return 0.0;
  }
  const double along = to_center.dot(direction);
  const double discriminant = along * along - square;
  if (along <= 0.0 || discriminant < 0.0) {
    return std::nullopt;
  }
  return along - std::sqrt(discriminant);
}

}  // namespace

std::optional<RayHit> Surroundings::castRay(const Eigen::Vector2d& origin, double angle,
                                            double max_range) const {
  std::optional<RayHit> nearest = world_.castRay(origin, angle, max_range);
  if (discs_ == nullptr) {
    return nearest;
  }
  const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
  for (const Disc& disc : *discs_) {
    const auto range = rangeOf(disc, origin, direction);
    if (range && *range <= (nearest ? nearest->range : max_range)) {
      nearest = RayHit{*range, Material::kWall};
    }
  }
  return nearest;
}

std::optional<Eigen::Vector2d> Surroundings::nearestObstacle(const Eigen::Vector2d& center,
                                                             double radius) const {
  std::optional<Eigen::Vector2d> nearest = world_.nearestObstacle(center, radius);
  if (discs_ == nullptr) {
    return nearest;
  }
  double least = nearest ? (*nearest - center).norm() : radius;
  for (const Disc& disc : *discs_) {
    const double distance = (disc.center - center).norm();
    if (distance - disc.radius < least) {
      least = std::max(0.0, distance - disc.radius);
      nearest =
          distance <= disc.radius
              ? center
              : Eigen::Vector2d(disc.center + (center - disc.center) * (disc.radius / distance));
    }
  }
  return nearest;
}

}  // namespace omega_slam::simulation

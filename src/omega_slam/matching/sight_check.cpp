#include "omega_slam/matching/sight_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::matching {

namespace {

constexpr int kSectors = 360;
constexpr double kMargin = 0.2;        // [m] that a point must be in front
constexpr double kMarginShare = 0.05;  // and of its range: a pose that is off by a little turns it
constexpr double kInfinity = std::numeric_limits<double>::infinity();

int sectorOf(const Eigen::Vector2d& way) {
  const double turns = std::atan2(way.y(), way.x()) / (2.0 * geometry::kPi) + 0.5;
  return std::clamp(static_cast<int>(turns * kSectors), 0, kSectors - 1);
}

/// Nearest return of each sector around the eye [m].
std::vector<double> nearestReturns(const View& eye) {
  std::vector<double> nearest(kSectors, kInfinity);
  for (const Eigen::Vector2d& point : eye.points) {
    const Eigen::Vector2d way = point - eye.origin;
    double& least = nearest[static_cast<std::size_t>(sectorOf(way))];
    least = std::min(least, way.norm());
  }
  return nearest;
}

}  // namespace

SightCheck checkSight(const View& eye, const View& seen) {
  const std::vector<double> nearest = nearestReturns(eye);
  SightCheck check;
  for (const Eigen::Vector2d& point : seen.points) {
    const Eigen::Vector2d way = point - eye.origin;
    const int sector = sectorOf(way);
    double least = kInfinity;
    bool is_watched = true;  // by beams on either side
    for (int side = -1; side <= 1; ++side) {
      const auto beside = static_cast<std::size_t>((sector + side + kSectors) % kSectors);
      is_watched = is_watched && std::isfinite(nearest[beside]);
      least = std::min(least, nearest[beside]);
    }
    const double range = way.norm();
    const double margin = kMargin + kMarginShare * range;
    if (!is_watched || range > least + margin) {
      continue;
    }
    ++check.compared;
    if (range < least - margin) {
      ++check.seen_through;
    }
  }
  return check;
}

SightCheck checkSightBothWays(const View& a, const View& b) {
  const SightCheck one = checkSight(a, b);
  const SightCheck other = checkSight(b, a);
  return {one.compared + other.compared, one.seen_through + other.seen_through};
}

}  // namespace omega_slam::matching

#include "omega_slam/navigation/seen_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace omega_slam::navigation {
namespace {

constexpr double kReach = 0.9;   // [m] from the robot: motions are looked at so far ahead
constexpr double kMemory = 2.0;  // [s]
constexpr double kSame = 0.01;   // [m] points that are nearer to each other are one

}  // namespace

void SeenWalls::see(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& robot,
                    double stamp) {
  const auto isPast = [&](const Mark& mark) {
    return std::abs(stamp - mark.stamp) > kMemory || (mark.point - robot).norm() > kReach;
  };
  marks_.erase(std::remove_if(marks_.begin(), marks_.end(), isPast), marks_.end());
  for (const Eigen::Vector2d& point : points) {
    if ((point - robot).norm() > kReach) {
      continue;
    }
    const auto known = std::find_if(marks_.begin(), marks_.end(), [&](const Mark& mark) {
      return (mark.point - point).squaredNorm() < kSame * kSame;
    });
    if (known != marks_.end()) {
      known->stamp = stamp;
    } else {
      marks_.push_back({point, stamp});
    }
  }
}

double SeenWalls::distance(const Eigen::Vector2d& point) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Mark& mark : marks_) {
    least = std::min(least, (mark.point - point).squaredNorm());
  }
  return std::sqrt(least);
}

}  // namespace omega_slam::navigation

#include "omega_slam/mapping/ray_fan.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::mapping {
namespace {

/// Rays whose number is a multiple of this are drawn whole.
constexpr std::size_t kWidestGroup = 32;

}  // namespace

RayFan::RayFan(const Eigen::Vector2d& start, const std::vector<Eigen::Vector2d>& ends) {
  const Eigen::Vector2d cell = start.array().floor();
  rays_.reserve(ends.size());
  for (const Eigen::Vector2d& end : ends) {
    const Eigen::Vector2d way = end - start;
    const int axis = std::abs(way.x()) > std::abs(way.y()) ? 0 : 1;
    const bool is_upward = way[axis] >= 0.0;
    const double to_border = is_upward ? cell[axis] + 1.0 - start[axis] : start[axis] - cell[axis];
    rays_.push_back({is_upward ? axis + 1 : -axis - 1, std::abs(way[axis]),
                     way[1 - axis] / way[axis], to_border});
  }
}

int RayFan::coveredBorders(std::size_t ray) const {
  constexpr double kLessThanACell = 1.0 - 1e-6;
  const std::size_t group = ray & (~ray + 1);  // the greatest power of two that divides it
  if (group == 0 || group >= kWidestGroup || ray + group >= rays_.size()) {
    return 0;
  }
  const Ray& here = rays_[ray];
  const Ray& before = rays_[ray - group];
  const Ray& after = rays_[ray + group];
  const auto [low, high] = std::minmax(before.slope, after.slope);
  // Written so that NaN, of a ray without length, fails.
  if (before.direction != here.direction || after.direction != here.direction ||
      !(low <= here.slope && here.slope <= high)) {
    return 0;
  }
  const double nearer_end = std::min(before.reach, after.reach);
  const double gap = high - low;
  const double covered = gap * nearer_end > kLessThanACell ? kLessThanACell / gap : nearer_end;
  return covered >= here.to_border ? static_cast<int>(covered - here.to_border) + 1 : 0;
}

}  // namespace omega_slam::mapping

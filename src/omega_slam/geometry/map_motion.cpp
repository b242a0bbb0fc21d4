#include "omega_slam/geometry/map_motion.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::geometry {

MapMotion::MapMotion(std::vector<Pose2> before, std::vector<Pose2> after)
    : before_(std::move(before)), after_(std::move(after)) {
  const std::size_t count = std::min(before_.size(), after_.size());
  before_.resize(count);
  after_.resize(count);
}

bool MapMotion::exceeds(double tolerance, double reach) const {
  for (std::size_t i = 0; i < before_.size(); ++i) {
    const double turn = std::abs(angleDifference(after_[i].theta, before_[i].theta));
    if (distance(before_[i], after_[i]) + turn * reach > tolerance) {
      return true;
    }
  }
  return false;
}

Pose2 MapMotion::around(const Eigen::Vector2d& point) const {
  if (before_.empty()) {
    return {};
  }
  const auto nearest =
      std::min_element(before_.begin(), before_.end(), [&point](const Pose2& a, const Pose2& b) {
        return (a.translation() - point).squaredNorm() < (b.translation() - point).squaredNorm();
      });
  return after_[static_cast<std::size_t>(nearest - before_.begin())] * nearest->inverse();
}

Eigen::Vector2d MapMotion::apply(const Eigen::Vector2d& point) const {
  return around(point) * point;
}

Pose2 MapMotion::apply(const Pose2& pose) const { return around(pose.translation()) * pose; }

}  // namespace omega_slam::geometry

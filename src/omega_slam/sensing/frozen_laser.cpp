#include "omega_slam/sensing/frozen_laser.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::sensing {

using geometry::Pose2;

namespace {

// By less than this a robot that stands may seem to move.
constexpr double kTranslation = 0.02;  // [m]
constexpr double kRotation = 0.02;     // [rad]

/// NaN being the same as NaN.
bool areSame(const std::vector<float>& a, const std::vector<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

}  // namespace

bool FrozenLaser::repeats(const std::vector<float>& ranges, const Pose2& T_odom_base) {
  if (!areSame(ranges, ranges_)) {
    ranges_ = ranges;
    T_odom_base_ = T_odom_base;
    return false;
  }
  const Pose2 motion = relativePose(T_odom_base_, T_odom_base);
  return std::hypot(motion.x, motion.y) > kTranslation || std::abs(motion.theta) > kRotation;
}

}  // namespace omega_slam::sensing

#pragma once

#include <random>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::test {

/// Length of translation and size of turn between two poses: of `inverse(a) * b`, never of raw
/// angles.
struct PoseGap {
  double translation;  ///< [m]
  double rotation;     ///< [rad], >= 0
};

[[nodiscard]] PoseGap gapBetween(const geometry::Pose2& a, const geometry::Pose2& b);

/// Uniform within +-`reach` [m] on both axes and +-`turn` [rad].
[[nodiscard]] geometry::Pose2 randomPose(double reach, double turn, std::mt19937_64& random);

}  // namespace omega_slam::test

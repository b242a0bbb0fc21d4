#include "support/poses.h"

#include <cmath>

namespace omega_slam::test {

PoseGap gapBetween(const geometry::Pose2& a, const geometry::Pose2& b) {
  const geometry::Pose2 gap = relativePose(a, b);
  return {std::hypot(gap.x, gap.y), std::abs(gap.theta)};
}

geometry::Pose2 randomPose(double reach, double turn, std::mt19937_64& random) {
  std::uniform_real_distribution<double> position(-reach, reach);
  std::uniform_real_distribution<double> heading(-turn, turn);
  const double x = position(random);
  const double y = position(random);
  return {x, y, heading(random)};
}

}  // namespace omega_slam::test

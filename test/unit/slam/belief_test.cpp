#include "omega_slam/slam/belief.h"

#include <gtest/gtest.h>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::slam {
namespace {

TEST(BeliefTest, DifferencesOfAnglesGoTheShortWay) {
  const auto difference =
      differenceOf({3.0, 1.0, geometry::kPi - 0.1}, {1.0, 2.0, 0.1 - geometry::kPi});
  EXPECT_DOUBLE_EQ(difference.x(), 2.0);
  EXPECT_DOUBLE_EQ(difference.y(), -1.0);
  EXPECT_NEAR(difference[2], -0.2, 1e-12);
}

TEST(BeliefTest, DistanceIsInDeviationsOfBothTogether) {
  const Belief a{{0.0, 0.0, 0.0}, Eigen::Vector3d(9.0, 1.0, 1.0).asDiagonal()};
  const Belief b{{10.0, 0.0, 0.0}, Eigen::Vector3d(16.0, 1.0, 1.0).asDiagonal()};
  EXPECT_NEAR(squaredDistance(a, b), 4.0, 1e-12);
  EXPECT_NEAR(squaredDistance(b, a), 4.0, 1e-12);
}

}  // namespace
}  // namespace omega_slam::slam

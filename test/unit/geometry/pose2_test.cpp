#include "omega_slam/geometry/pose2.h"

#include <gtest/gtest.h>

namespace omega_slam::geometry {
namespace {

TEST(PointTransform, PutsPointsWhereThePoseDoes) {
  const Pose2 pose{1.5, -0.25, 2.0};
  const PointTransform transform(pose);
  for (const Eigen::Vector2d& point :
       {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(3.0, -4.0), Eigen::Vector2d(1e-3, 1e6)}) {
    EXPECT_EQ(transform * point, pose * point);
    EXPECT_NEAR((transform * point - (pose.rotation() * point + pose.translation())).norm(), 0.0,
                1e-9);
  }
}

}  // namespace
}  // namespace omega_slam::geometry

#include "omega_slam/matching/scan_motion.h"

#include <gtest/gtest.h>

#include "omega_slam/geometry/angle.h"
#include "support/poses.h"

namespace omega_slam::matching {
namespace {

using geometry::kPi;
using geometry::Pose2;

TEST(ScanMotion, MeasuresFromLaserToLaser) {
  const Reference reference{{{}, {9.0, 9.0}}, {{}, {1.0, 2.0}}};
  const View scan{{}, {0.5, 0.0}};
  const ScanMotion motion(reference, scan);
  const Eigen::Vector3d variables = motion.fromPose({1.0, 3.5, kPi / 2.0});
  EXPECT_NEAR(variables[kDirection], kPi / 2.0, 1e-12);
  EXPECT_NEAR(variables[kDistance], 2.0, 1e-12);
  EXPECT_NEAR(variables[kRotation], kPi / 2.0, 1e-12);
}

TEST(ScanMotion, ThereAndBack) {
  const ScanMotion motion({{{}, {1.0, 2.0}}}, {{}, {0.5, -0.2}});
  std::mt19937_64 random(1);
  for (int i = 0; i < 20; ++i) {
    const Pose2 pose = test::randomPose(5.0, 3.1, random);
    EXPECT_LT((motion.toPose(motion.fromPose(pose)).vector() - pose.vector()).norm(), 1e-12);
  }
}

TEST(ScanMotion, WhereNothingMovesTheDirectionIsTheHeading) {
  const ScanMotion motion({{{}, {1.0, 2.0}}}, {});
  EXPECT_EQ(motion.fromPose({1.0, 2.0, 0.7})[kDirection], 0.7);
}

TEST(ScanMotion, NegativeDistanceIsBackwards) {
  const Pose2 back = ScanMotion({{}}, {}).toPose({0.0, -1.5, 0.2});
  EXPECT_NEAR(back.x, -1.5, 1e-12);
  EXPECT_NEAR(back.theta, 0.2, 1e-12);
}

}  // namespace
}  // namespace omega_slam::matching

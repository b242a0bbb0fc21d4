#include "omega_slam/motion/odometry_motion_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "support/poses.h"

namespace omega_slam::motion {
namespace {

using geometry::kPi;
using geometry::Pose2;

TEST(RotTransRot, SplitsAStep) {
  const auto motion = RotTransRot::fromMotion({1.0, 1.0, kPi / 2.0});
  EXPECT_NEAR(motion.rot1, kPi / 4.0, 1e-12);
  EXPECT_NEAR(motion.trans, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(motion.rot2, kPi / 4.0, 1e-12);
}

TEST(RotTransRot, DrivingInReverseIsNotTwoHalfTurns) {
  const auto motion = RotTransRot::fromMotion({-1.0, 0.0, 0.0});
  EXPECT_NEAR(motion.rot1, 0.0, 1e-12);
  EXPECT_NEAR(motion.trans, -1.0, 1e-12);
  EXPECT_NEAR(motion.rot2, 0.0, 1e-12);
}

TEST(RotTransRot, TurningOnTheSpotHasOneRotation) {
  const auto motion = RotTransRot::fromMotion({1e-9, -1e-9, 0.5});
  EXPECT_EQ(motion.trans, 0.0);
  EXPECT_NEAR(motion.rot1, 0.5, 1e-12);
  EXPECT_EQ(motion.rot2, 0.0);
}

TEST(OdometryMotionModel, WithoutNoiseTheMotionIsTheMeasuredOne) {
  const OdometryMotionModel model({0.0, 0.0, 0.0, 0.0});
  std::mt19937_64 random(1);
  const Pose2 measured{0.4, -0.1, 0.3};
  const auto gap = test::gapBetween(model.sample(measured, random), measured);
  EXPECT_LT(gap.translation, 1e-12);
  EXPECT_LT(gap.rotation, 1e-12);
  EXPECT_TRUE(model.covariance(measured).isZero());
}

TEST(OdometryMotionModel, RobotThatStandsStillStays) {
  const OdometryMotionModel model;
  std::mt19937_64 random(1);
  EXPECT_EQ(test::gapBetween(model.sample({}, random), {}).translation, 0.0);
  EXPECT_TRUE(model.covariance({}).isZero());
}

TEST(OdometryMotionModel, DensityIsHighestAtTheMeasuredMotion) {
  const OdometryMotionModel model;
  const Pose2 measured{0.5, 0.1, 0.2};
  const double best = model.density(measured, measured);
  EXPECT_GT(best, model.density({0.55, 0.1, 0.2}, measured));
  EXPECT_GT(best, model.density({0.5, 0.1, 0.3}, measured));
  EXPECT_GT(model.density({0.52, 0.1, 0.2}, measured), model.density({0.6, 0.1, 0.2}, measured));
}

TEST(OdometryMotionModel, ConfigurationIsChecked) {
  OdometryMotionModelConfig config;
  config.translation_per_rotation = std::nan("");
  config.rotation_per_rotation = -0.1;
  EXPECT_EQ(config.validate().size(), 2U);
  EXPECT_THROW(OdometryMotionModel{config}, std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::motion

#include "omega_slam/simulation/odometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace omega_slam::simulation {
namespace {

constexpr double kStep = 0.02;

OdometryConfig withoutNoise() {
  OdometryConfig config;
  config.noise = {0.0, 0.0, 0.0, 0.0};
  return config;
}

TEST(Odometry, IsExactWithoutNoise) {
  Odometry odometry(withoutNoise(), 1);
  geometry::Pose2 truth;
  for (int i = 0; i < 500; ++i) {
    const Arc arc{0.01 * std::sin(0.1 * i), 0.02 * std::cos(0.07 * i)};
    odometry.advance(arc, kStep);
    truth = truth * arc.toMotion();
  }
  EXPECT_LT(geometry::relativePose(truth, odometry.pose()).vector().norm(), 1e-12);
}

TEST(Odometry, WheelsTurnAsTheBaseMoves) {
  Odometry odometry(withoutNoise(), 1);
  odometry.advance({0.07, 0.0}, kStep);
  EXPECT_NEAR(odometry.leftWheel().angle, 2.0, 1e-12);  // 7 cm on a wheel of 3.5 cm
  EXPECT_NEAR(odometry.rightWheel().angle, 2.0, 1e-12);
  EXPECT_NEAR(odometry.leftWheel().speed, 2.0 / kStep, 1e-9);
  odometry.advance({0.0, 1.0}, kStep);
  EXPECT_NEAR(odometry.leftWheel().angle, 2.0 - 0.115 / 0.035, 1e-12);
  EXPECT_NEAR(odometry.rightWheel().angle, 2.0 + 0.115 / 0.035, 1e-12);
}

TEST(Odometry, StandingStillHasNoError) {
  Odometry odometry({}, 1);
  for (int i = 0; i < 1000; ++i) {
    odometry.advance({}, kStep);
  }
  EXPECT_EQ(odometry.pose().vector(), Eigen::Vector3d::Zero());
}

TEST(Odometry, ErrorsStayTheSameForASegment) {
  OdometryConfig config;
  config.segment = 0.5;
  Odometry odometry(config, 3);
  std::vector<double> felt;
  for (int i = 0; i < 75; ++i) {
    odometry.advance({0.01, 0.0}, kStep);
    felt.push_back(odometry.linearSpeed());
  }
  for (int i = 0; i < 75; ++i) {
    EXPECT_EQ(felt[i] == felt[0], i < 25) << "step " << i;
    EXPECT_EQ(felt[i] == felt[25], i >= 25 && i < 50) << "step " << i;
  }
}

TEST(Odometry, ResetKeepsTheErrorsGoing) {
  Odometry odometry({}, 1);
  odometry.advance({1.0, 0.5}, kStep);
  odometry.reset();
  EXPECT_EQ(odometry.pose().vector(), Eigen::Vector3d::Zero());
  EXPECT_EQ(odometry.leftWheel().angle, 0.0);
  odometry.advance({1.0, 0.0}, kStep);
  EXPECT_NE(odometry.pose().x, 1.0);
}

TEST(OdometryConfiguration, NamesEveryViolation) {
  OdometryConfig config;
  EXPECT_TRUE(config.validate().empty());
  config.noise.translation_per_rotation = -0.1;
  config.segment = 0.0;
  EXPECT_THAT(config.validate(),
              ::testing::ElementsAre(::testing::HasSubstr("translation_per_rotation"),
                                     ::testing::HasSubstr("segment")));
  EXPECT_THROW(Odometry(config, 1), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::simulation

#include "omega_slam/motion/odometry_motion_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/motion/motion_predictor.h"
#include "support/poses.h"
#include "support/seeds.h"

namespace omega_slam::motion {
namespace {

using geometry::Pose2;

TEST(OdometryMotionModelLaws, SplitAndJoinIsTheIdentity) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 1000; ++i) {
      const Pose2 motion = test::randomPose(2.0, 3.2, random);
      const auto gap = test::gapBetween(RotTransRot::fromMotion(motion).toMotion(), motion);
      EXPECT_LT(gap.translation, 1e-9);
      EXPECT_LT(gap.rotation, 1e-9);
    }
  }
}

/// The three faces of one model: what it draws has the covariance that its Jacobian says.
TEST(OdometryMotionModelLaws, SamplesHaveTheCovarianceOfTheJacobian) {
  const OdometryMotionModel model({0.05, 0.04, 0.06, 0.02});
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Pose2 measured{0.8, 0.3, 0.5};
    constexpr int kDraws = 40000;
    Eigen::Matrix3d drawn = Eigen::Matrix3d::Zero();
    for (int i = 0; i < kDraws; ++i) {
      const Pose2 sample = model.sample(measured, random);
      const Eigen::Vector3d error(sample.x - measured.x, sample.y - measured.y,
                                  geometry::angleDifference(sample.theta, measured.theta));
      drawn += error * error.transpose() / kDraws;
    }
    const Eigen::Matrix3d predicted = model.covariance(measured);
    EXPECT_LT((drawn - predicted).norm(), 0.05 * predicted.norm());
  }
}

/// The density integrates to one over (rot1, trans, rot2): Monte Carlo over a box that holds nearly
/// all of it.
TEST(OdometryMotionModelLaws, DensityIsADensity) {
  const OdometryMotionModel model({0.1, 0.05, 0.1, 0.05});
  const RotTransRot measured{0.4, 1.0, 0.3};
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> within(-0.6, 0.6);
    constexpr int kDraws = 400000;
    double sum = 0.0;
    for (int i = 0; i < kDraws; ++i) {
      const RotTransRot at{measured.rot1 + within(random), measured.trans + within(random),
                           measured.rot2 + within(random)};
      sum += model.density(at.toMotion(), measured.toMotion());
    }
    const double volume = std::pow(1.2, 3);
    // The deviations depend a little on the hypothesis, as in the textbook: near one, not just one;
    // of 100 seeds, off by 0.071 at most.
    EXPECT_NEAR(sum / kDraws * volume, 1.0, 0.08);
  }
}

TEST(MotionPredictorLaws, SamplesSpreadAsTheCovarianceSays) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    MotionPredictor predictor({0.05, 0.03, 0.05, 0.01}, 5000, seed);
    Pose2 T_odom_base{3.0, -2.0, 1.0};
    Prediction prediction = predictor.predict(0.0, T_odom_base);
    EXPECT_TRUE(prediction.covariance.isZero());
    for (int i = 1; i <= 150; ++i) {  // 3 s at 50 Hz: 1.5 m along a bend
      T_odom_base = T_odom_base * Pose2{0.01, 0.0, 0.005};
      prediction = predictor.predict(0.02 * i, T_odom_base);
    }
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    const auto samples = predictor.samples();
    ASSERT_EQ(samples.size(), 5000U);
    for (const Pose2& sample : samples) {
      const Eigen::Vector3d error(sample.x - T_odom_base.x, sample.y - T_odom_base.y,
                                  geometry::angleDifference(sample.theta, T_odom_base.theta));
      spread += error * error.transpose() / 5000.0;
    }
    EXPECT_LT((spread - prediction.covariance).norm(), 0.1 * prediction.covariance.norm());
  }
}

/// The reason for segments: how often the odometry is sampled must not change what it is worth.
TEST(MotionPredictorLaws, RateOfTheOdometryDoesNotMatter) {
  const auto traceAfter = [](int steps) {
    MotionPredictor predictor;
    Prediction prediction;
    for (int i = 0; i <= steps; ++i) {
      prediction = predictor.predict(i, {2.0 * i / steps, 0.0, 0.0});
    }
    return prediction.covariance.trace();
  };
  EXPECT_NEAR(traceAfter(1000) / traceAfter(40), 1.0, 0.1);
}

TEST(MotionPredictorLaws, AnchorForgetsTheSpread) {
  MotionPredictor predictor({}, 10, 1);
  (void)predictor.predict(0.0, {});
  EXPECT_GT(predictor.predict(1.0, {1.0, 0.0, 0.0}).covariance.trace(), 0.0);
  predictor.anchor({1.0, 0.0, 0.0});
  EXPECT_TRUE(predictor.predict(2.0, {1.0, 0.0, 0.0}).covariance.isZero());
  for (const Pose2& sample : predictor.samples()) {
    EXPECT_EQ(test::gapBetween(sample, {1.0, 0.0, 0.0}).translation, 0.0);
  }
}

TEST(MotionPredictorLaws, SameSeedSameSamples) {
  const auto draw = [](std::uint64_t seed) {
    MotionPredictor predictor({}, 3, seed);
    (void)predictor.predict(0.0, {});
    (void)predictor.predict(1.0, {0.3, 0.0, 0.1});
    return predictor.samples()[2].x;
  };
  EXPECT_EQ(draw(7), draw(7));
  EXPECT_NE(draw(7), draw(8));
}

}  // namespace
}  // namespace omega_slam::motion

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "omega_slam/motion/odometry_motion_model.h"
#include "omega_slam/simulation/hokuyo.h"
#include "omega_slam/simulation/odometry.h"
#include "support/drawn_world.h"
#include "support/seeds.h"

namespace omega_slam::simulation {
namespace {

constexpr double kStep = 0.02;
constexpr int kSegments = 20000;
/// The deviation of n normal draws is itself known to 1 / sqrt(2 n); this is five of those.
const double kDeviationTolerance = 5.0 / std::sqrt(2.0 * kSegments);

/// Standard deviations of (x, y, heading) of a segment's odometry, seen from where it truly ended.
Eigen::Vector3d segmentDeviations(const Arc& segment, std::uint64_t seed) {
  const OdometryConfig config;
  const int steps = static_cast<int>(std::lround(config.segment / kStep));
  const Arc step{segment.length / steps, segment.turn / steps};
  Odometry odometry(config, seed);
  Eigen::Array3d squares = Eigen::Array3d::Zero();
  for (int i = 0; i < kSegments; ++i) {
    const geometry::Pose2 start = odometry.pose();
    for (int k = 0; k < steps; ++k) {
      odometry.advance(step, kStep);
    }
    const geometry::Pose2 measured = geometry::relativePose(start, odometry.pose());
    const geometry::Pose2 truth = segment.toMotion();
    const Eigen::Array3d error(measured.x - truth.x, measured.y - truth.y,
                               geometry::angleDifference(measured.theta, truth.theta));
    squares += error.square();
  }
  return (squares / kSegments).sqrt();
}

Eigen::Vector3d modelDeviations(const Arc& segment) {
  const motion::OdometryMotionModel model(OdometryConfig{}.noise);
  return model.covariance(segment.toMotion()).diagonal().cwiseSqrt();
}

void expectRelativelyNear(double actual, double expected) {
  EXPECT_NEAR(actual / expected, 1.0, kDeviationTolerance);
}

TEST(OdometryNoiseProperty, AStraightSegmentHasTheModelsDeviations) {
  const Arc segment{0.25, 0.0};
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    const Eigen::Vector3d actual = segmentDeviations(segment, seed);
    const Eigen::Vector3d model = modelDeviations(segment);
    expectRelativelyNear(actual.x(), model.x());
    expectRelativelyNear(actual.z(), model.z());
    // The drift on a curve, as documented.
    expectRelativelyNear(
        actual.y(), 0.25 * 0.25 * OdometryConfig{}.noise.rotation_per_translation / std::sqrt(2.0));
  }
}

TEST(OdometryNoiseProperty, ATurnOnTheSpotHasTheModelsDeviations) {
  const Arc segment{0.0, 0.6};
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    const Eigen::Vector3d actual = segmentDeviations(segment, seed);
    expectRelativelyNear(actual.z(), modelDeviations(segment).z());
    const double displacement = std::hypot(actual.x(), actual.y());
    const double chord = std::sin(0.3) / 0.3;  // the error bends with the turn
    EXPECT_NEAR(displacement / (chord * modelDeviations(segment).head<2>().norm()), 1.0, 0.05);
  }
}

TEST(OdometryNoiseProperty, AnArcIsBetweenTheModelAndTwiceItsVariance) {
  const Arc segment{0.2, 0.5};
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    const double ratio = segmentDeviations(segment, seed).z() / modelDeviations(segment).z();
    EXPECT_GT(ratio, 1.0);
    EXPECT_LT(ratio, std::sqrt(2.0));
  }
}

/// Errors of beams that look straight at a wall, many times.
std::vector<double> rangeErrors(double range, const HokuyoConfig& config, std::uint64_t seed) {
  const auto room = test::emptyRoom(4.0, 0.1);
  const geometry::Pose2 T_world_laser{4.0 - range, 0.0, 0.0};
  Hokuyo hokuyo(config, 0.0, seed);
  std::vector<double> errors;
  double now = 0.0;
  while (errors.size() < static_cast<std::size_t>(kSegments)) {
    const auto scan = hokuyo.sweep(*room, {now, T_world_laser}, {now + 0.1, T_world_laser});
    now += 0.1;
    if (!scan) {
      continue;
    }
    for (std::size_t i = 331; i <= 351; ++i) {
      const double angle = scan->angle_min + static_cast<double>(i) * scan->angle_increment;
      errors.push_back(static_cast<double>(scan->ranges[i]) - range / std::cos(angle));
    }
  }
  return errors;
}

TEST(LaserNoiseProperty, ErrorsKeepToTheDataSheetAndFillIt) {
  const HokuyoConfig config;
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    for (const double range : {0.3, 0.9, 1.2, 3.5}) {
      SCOPED_TRACE(range);
      const double bound = range < 1.0 ? 0.03 : 0.03 * range;
      double sum = 0.0;
      double squares = 0.0;
      const std::vector<double> errors = rangeErrors(range, config, seed);
      for (const double error : errors) {
        EXPECT_LE(std::abs(error), bound * 1.01 + 1e-6);  // oblique beams are a little longer
        sum += error;
        squares += error * error;
      }
      const auto count = static_cast<double>(errors.size());
      const double deviation = std::sqrt(squares / count);
      EXPECT_NEAR(sum / count, 0.0, 5.0 * deviation / std::sqrt(count));
      // A normal law cut at three deviations is 1.3 % narrower than one that is not.
      EXPECT_NEAR(deviation / (bound / 3.0), 0.9866, 0.03);
    }
  }
}

}  // namespace
}  // namespace omega_slam::simulation

#include "omega_slam/slam/odometry_calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "omega_slam/motion/arc.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;

/// Deviations of the odometry's motions and of the match's [m], [m], [rad].
struct Noise {
  Eigen::Vector3d odometry{0.006, 0.003, 0.008};
  Eigen::Vector3d match{0.005, 0.003, 0.004};
};

Eigen::Matrix3d covarianceOf(const Eigen::Vector3d& deviations) {
  return deviations.cwiseAbs2().asDiagonal();
}

Belief standing() { return {{}, covarianceOf(Noise{}.match)}; }

/// A robot that drives arcs, and what it learns of its odometry.
class Calibrated {
 public:
  explicit Calibrated(std::uint64_t seed) : random_(seed) {}

  /// Drives so many arcs of 0.4 m with an odometry that has these faults.
  /// @param turning [rad] deviation of the turns
  void drive(int arcs, const OdometryFaults& faults, const Noise& noise = {},
             double turning = 0.3) {
    std::normal_distribution<double> normal;
    const auto off = [&](const Pose2& motion, const Eigen::Vector3d& by) {
      const Eigen::Vector3d error{by.x() * normal(random_), by.y() * normal(random_),
                                  by.z() * normal(random_)};
      return Belief{Pose2::fromVector(motion.vector() + error), covarianceOf(by)};
    };
    for (int i = 0; i < arcs; ++i) {
      const motion::Arc felt{0.4, turning * normal(random_)};
      const Belief by_odometry = off(felt.toMotion(), noise.odometry);
      calibration.note(by_odometry, off(trueMotion(felt, faults), noise.match));
    }
  }

  /// What becomes of an arc that is felt by an odometry with these faults.
  static Pose2 trueMotion(const motion::Arc& felt, const OdometryFaults& faults) {
    const motion::Arc driven{(1.0 + faults.way) * felt.length,
                             (1.0 + faults.turn) * felt.turn + faults.bend * felt.length};
    const Pose2 laser{0.0, 0.0, faults.aside};
    return laser * driven.toMotion() * laser.inverse();
  }

  OdometryCalibration calibration;

 private:
  std::mt19937_64 random_;
};

void expectNear(const OdometryFaults& a, const OdometryFaults& b, double tolerance) {
  EXPECT_NEAR(a.way, b.way, tolerance);
  EXPECT_NEAR(a.aside, b.aside, tolerance);
  EXPECT_NEAR(a.turn, b.turn, tolerance);
  EXPECT_NEAR(a.bend, b.bend, tolerance);
}

const std::vector<OdometryFaults> kFaults{{0.05, 0.0, 0.0, 0.0}, {-0.08, 0.0, 0.0, 0.0},
                                          {0.0, 0.05, 0.0, 0.0}, {0.0, 0.0, -0.1, 0.0},
                                          {0.0, 0.0, 0.0, 0.04}, {0.04, -0.04, 0.06, -0.03}};

TEST(OdometryCalibration, FaultsAreLearntFromWhatWasSeen) {
  for (const OdometryFaults& faults : kFaults) {
    Calibrated robot(1);
    robot.drive(400, faults);
    expectNear(robot.calibration.faults(), faults, 0.012);
  }
}

TEST(OdometryCalibration, MotionsAreCorrectedByThem) {
  const motion::Arc felt{0.4, 0.35};
  for (const OdometryFaults& faults : kFaults) {
    Calibrated robot(2);
    robot.drive(400, faults);
    const Pose2 driven = Calibrated::trueMotion(felt, faults);
    const Pose2 error = relativePose(driven, robot.calibration.corrected(felt.toMotion()));
    EXPECT_LT(std::hypot(error.x, error.y), 0.006);
    EXPECT_LT(std::abs(error.theta), 0.006);
  }
}

TEST(OdometryCalibration, ARobotWithoutFaultsGoesOnAsIfNothingWereLearnt) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Calibrated robot(seed);
    for (int i = 0; i < 20; ++i) {
      robot.drive(20, {});
      expectNear(robot.calibration.faults(), {}, 0.012);
    }
  }
}

TEST(OdometryCalibration, LongMotionsAreLeftAsTheyAre) {
  Calibrated robot(6);
  robot.drive(400, kFaults.back());
  for (const Pose2& motion : {Pose2{3.0, 0.1, 0.2}, Pose2{0.1, -3.0, 0.2}, Pose2{0.1, 0.1, 2.0}}) {
    EXPECT_FALSE(OdometryCalibration::isFor(motion));
    EXPECT_EQ(robot.calibration.corrected(motion).vector(), motion.vector());
  }
}

TEST(OdometryCalibration, FaultsThatChangeAreFollowed) {
  Calibrated robot(3);
  robot.drive(3000, {0.05, 0.0, 0.0, 0.02});
  robot.drive(1000, {0.02, 0.0, 0.0, 0.04});
  expectNear(robot.calibration.faults(), {0.02, 0.0, 0.0, 0.04}, 0.012);
}

TEST(OdometryCalibration, WhatAMatchDoesNotKnowTeachesNothing) {
  Noise corridor;
  corridor.match.x() = 1.0;  // the way along is not seen
  Calibrated robot(4);
  robot.drive(400, {0.0, 0.0, -0.1, 0.0}, corridor);
  expectNear(robot.calibration.faults(), {0.0, 0.0, -0.1, 0.0}, 0.015);
}

TEST(OdometryCalibration, TurnsThatAreNothingButNoiseTeachNothing) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Calibrated robot(seed);
    robot.drive(1000, {}, {}, 0.0);
    expectNear(robot.calibration.faults(), {}, 0.05);
  }
}

TEST(OdometryCalibration, ARobotThatStandsForgetsNothing) {
  Calibrated robot(7);
  robot.drive(400, kFaults.back());
  const OdometryFaults before = robot.calibration.faults();
  for (int i = 0; i < 100000; ++i) {  // eleven days, with a keyframe every ten seconds
    robot.calibration.note({{0.002, 0.0, 0.001}, covarianceOf(Noise{}.odometry)}, standing());
  }
  expectNear(robot.calibration.faults(), before, 0.0);
}

TEST(OdometryCalibration, ARobotThatOnlyTurnsLearnsNothingOfItsWays) {
  Calibrated robot(8);
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100000; ++i) {
    robot.calibration.note({{0.004 * normal(random), 0.0, 0.4}, covarianceOf(Noise{}.odometry)},
                           {{0.004 * normal(random), 0.0, 0.4}, covarianceOf(Noise{}.match)});
  }
  EXPECT_NEAR(robot.calibration.faults().way, 0.0, 0.1);
  EXPECT_NEAR(robot.calibration.faults().aside, 0.0, 0.1);
}

TEST(OdometryCalibration, SlipsTeachNothing) {
  Calibrated robot(5);
  robot.drive(400, {});
  const OdometryFaults before = robot.calibration.faults();
  for (int i = 0; i < 20; ++i) {
    robot.calibration.note({{0.4, 0.0, 0.0}, covarianceOf(Noise{}.odometry)},
                           {{0.1, 0.0, 0.0}, covarianceOf(Noise{}.match)});
  }
  expectNear(robot.calibration.faults(), before, 0.0);
}

TEST(OdometryCalibration, StandingStillAndNonsenseTeachNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  OdometryCalibration calibration;
  for (int i = 0; i < 100; ++i) {
    calibration.note({}, {});
    calibration.note({}, standing());
    calibration.note({{nan, 0.0, 0.0}, {}}, standing());
    calibration.note({{0.4, 0.0, 0.0}, Eigen::Matrix3d::Constant(nan)}, standing());
  }
  expectNear(calibration.faults(), {}, 0.0);
  const Pose2 motion = calibration.corrected({0.4, 0.1, 0.2});
  EXPECT_EQ(motion.vector(), Eigen::Vector3d(0.4, 0.1, 0.2));
}

TEST(OdometryFaults, AreDescribed) {
  EXPECT_EQ(describe({}), "");
  EXPECT_EQ(describe({0.004, 0.004, -0.004, 0.004}), "");
  EXPECT_EQ(describe({0.048, 0.0, -0.02, 0.0}),
            "ways are 4.8 % longer than it has them; turns are 2.0 % smaller");
  EXPECT_EQ(describe({0.0, 0.05, 0.0, -0.02}),
            "ways lead 2.9 degrees farther to the left, as if the laser looked as far to the right "
            "of its mount; each metre forward turns by 1.1 degrees more to the "
            "right");
}

}  // namespace
}  // namespace omega_slam::slam

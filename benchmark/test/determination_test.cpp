#include "experiments/determination.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "support/room.h"

namespace omega_slam::experiments {
namespace {

using geometry::Pose2;

constexpr Tolerance kTolerance{0.05, 0.0175};

double oneCentimetre(double /*range*/) { return 0.01; }

ScanPair samePlace(const test::Room& room, const Pose2& place, int beams) {
  std::mt19937_64 random(1);
  const matching::View view{test::measurePoints(room, place, beams, 0.0, random)};
  return {view, view, {}};
}

TEST(Determination, FurnishedRoomDeterminesAPose) {
  EXPECT_EQ(determinationOf(samePlace(test::furnishedRoom(), {}, 360), oneCentimetre, kTolerance),
            Determination::kDetermined);
}

TEST(Determination, CorridorIsOpenAlongItself) {
  const ScanPair pair = samePlace(test::endlessCorridor(), {0.0, 0.2, 0.3}, 360);
  EXPECT_EQ(determinationOf(pair, oneCentimetre, kTolerance), Determination::kOpenDirection);
  const Eigen::Matrix3d information = informationOf(pair, oneCentimetre);
  const Eigen::Vector3d along(std::cos(-0.3), std::sin(-0.3), 0.0);
  const Eigen::Vector3d across(-along.y(), along.x(), 0.0);
  EXPECT_LT(along.dot(information * along), 1.0);
  EXPECT_GT(across.dot(information * across), 1e5);
}

TEST(Determination, FewReturnsAreTooFew) {
  EXPECT_EQ(determinationOf(samePlace(test::furnishedRoom(), {}, 29), oneCentimetre, kTolerance),
            Determination::kTooFewReturns);
  EXPECT_EQ(determinationOf({}, oneCentimetre, kTolerance), Determination::kTooFewReturns);
}

TEST(Determination, MoreNoiseDeterminesLess) {
  const ScanPair pair = samePlace(test::furnishedRoom(), {}, 360);
  EXPECT_EQ(determinationOf(
                pair, [](double) { return 0.5; }, kTolerance),
            Determination::kOpenDirection);
}

/// A square room of half edge h, n beams all round: half of them see walls across x, each of which
/// tells (1 / (sigma * incidence))^2 / 2 of it; the mean of 1 / cos^2 over +-45 degrees is 4 / pi.
TEST(Information, IsAsCountedByHandInASquareRoom) {
  test::Room room;
  room.addBox({-2.0, -2.0}, {2.0, 2.0});
  const int beams = 2000;
  const Eigen::Matrix3d information = informationOf(samePlace(room, {}, beams), oneCentimetre);
  const double expected = 0.5 * beams * (4.0 / geometry::kPi) / (2.0 * 0.01 * 0.01);
  // Points near corners are on no line.
  EXPECT_NEAR(information(0, 0) / expected, 0.9, 0.1);
  EXPECT_NEAR(information(1, 1) / information(0, 0), 1.0, 0.01);
  EXPECT_NEAR(information(0, 1) / information(0, 0), 0.0, 0.01);
}

TEST(Information, TurnsWithTheReference) {
  const ScanPair pair = samePlace(test::furnishedRoom(), {0.5, 0.3, 0.0}, 720);
  ScanPair turned = pair;
  const Pose2 T_turned_reference{0.0, 0.0, geometry::kPi / 2.0};
  turned.reference = matching::transformed(T_turned_reference, pair.reference);
  turned.T_reference_scan = T_turned_reference * pair.T_reference_scan;
  const Eigen::Matrix3d before = informationOf(pair, oneCentimetre);
  const Eigen::Matrix3d after = informationOf(turned, oneCentimetre);
  EXPECT_NEAR(after(0, 0) / before(1, 1), 1.0, 1e-6);
  EXPECT_NEAR(after(1, 1) / before(0, 0), 1.0, 1e-6);
  EXPECT_NEAR(after(2, 2) / before(2, 2), 1.0, 1e-6);
}

TEST(PoseErrors, AreOfTheRelativePose) {
  const Pose2 truth{1.0, 2.0, 3.1};
  const PoseError error = errorOf(truth * Pose2{0.03, -0.04, 0.2}, truth);
  EXPECT_NEAR(error.translation, 0.05, 1e-12);
  EXPECT_NEAR(error.rotation, 0.2, 1e-12) << "across the seam of angles";
}

}  // namespace
}  // namespace omega_slam::experiments

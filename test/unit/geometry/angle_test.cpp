#include "omega_slam/geometry/angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace omega_slam::geometry {
namespace {

TEST(Angle, LiesInHalfOpenInterval) {
  EXPECT_DOUBLE_EQ(normalizeAngle(0.0), 0.0);
  EXPECT_DOUBLE_EQ(normalizeAngle(kPi), -kPi);
  EXPECT_DOUBLE_EQ(normalizeAngle(-kPi), -kPi);
  EXPECT_NEAR(normalizeAngle(3.0 * kPi + 0.1), -kPi + 0.1, 1e-12);
  EXPECT_NEAR(normalizeAngle(-7.0), 2.0 * kPi - 7.0, 1e-12);
}

TEST(Angle, NeverReachesPiByRounding) {
  const double just_below = std::nextafter(-kPi, -4.0);
  EXPECT_GE(normalizeAngle(just_below), -kPi);
  EXPECT_LT(normalizeAngle(just_below), kPi);
}

TEST(Angle, IsExactHoweverManyTurns) {
  // 2 kPi is a little less than a full turn; this is so many times it, to the last bit.
  EXPECT_EQ(normalizeAngle(std::ldexp(2.0 * kPi, 60)), 0.0);
  for (const double angle : {1e16, -1e16, 1e18, 1e300, std::numeric_limits<double>::max()}) {
    EXPECT_GE(normalizeAngle(angle), -kPi) << angle;
    EXPECT_LT(normalizeAngle(angle), kPi) << angle;
    EXPECT_EQ(normalizeAngle(angle), -normalizeAngle(-angle)) << angle;
  }
}

TEST(Angle, DifferenceTakesTheShortWay) {
  EXPECT_NEAR(angleDifference(-3.1, 3.1), 2.0 * kPi - 6.2, 1e-12);
  EXPECT_NEAR(angleDifference(3.1, -3.1), 6.2 - 2.0 * kPi, 1e-12);
}

TEST(Angle, NotFiniteGivesNaN) {
  EXPECT_TRUE(std::isnan(normalizeAngle(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(normalizeAngle(std::numeric_limits<double>::infinity())));
}

TEST(Angle, DegreesAndBack) { EXPECT_DOUBLE_EQ(radiansToDegrees(degreesToRadians(33.0)), 33.0); }

}  // namespace
}  // namespace omega_slam::geometry

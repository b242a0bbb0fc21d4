// What holds for every matcher that a configuration can name, whoever adds it.

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "omega_slam/geometry/covariance.h"
#include "omega_slam/matching/matcher_factory.h"
#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

class EveryMatcherLaws : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] std::unique_ptr<const ScanMatcher> matcher() const {
    MatcherConfig config;
    config.matcher = GetParam();
    return makeMatcher(config);
  }
};

View look(const Pose2& T_room_laser, std::mt19937_64& random) {
  return {test::measurePoints(test::furnishedRoom(), T_room_laser, 360, 0.01, random), {0.0, 0.0}};
}

/// The same two scans both ways: the results differ by less than the covariances allow.
TEST_P(EveryMatcherLaws, ThereAndBackIsNowhereWithinTheCovariances) {
  constexpr double kBound = 14.16;  // of three degrees of freedom, 99.7 %
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 3; ++i) {
      const Pose2 first = test::randomPose(0.8, 3.1, random);
      const Pose2 truth = test::randomPose(0.2, 0.2, random);
      const View a = look(first, random);
      const View b = look(first * truth, random);
      const auto forth = matcher()->match({a}, b, truth);
      const auto back = matcher()->match({b}, a, truth.inverse());
      const Pose2 gap = forth.T_reference_scan * back.T_reference_scan;
      const Eigen::Matrix3d covariance = geometry::composeCovariance(
          forth.T_reference_scan, forth.covariance, back.T_reference_scan, back.covariance);
      EXPECT_LT(gap.vector().dot(covariance.inverse() * gap.vector()), kBound) << i;
    }
  }
}

TEST_P(EveryMatcherLaws, TheSameCallGivesTheSameResult) {
  std::mt19937_64 random(4);
  const View a = look({}, random);
  const View b = look({0.1, 0.05, 0.1}, random);
  const View elsewhere = look({-1.5, 0.5, 2.0}, random);
  const auto used = matcher();
  const auto first = used->match({a}, b, {});
  static_cast<void>(used->match({elsewhere}, a, {}));
  for (const auto& again : {used->match({a}, b, {}), matcher()->match({a}, b, {})}) {
    EXPECT_EQ(again.T_reference_scan.vector(), first.T_reference_scan.vector());
    EXPECT_EQ(again.covariance, first.covariance);
    EXPECT_EQ(again.confidence, first.confidence);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryMatcherLaws, ::testing::ValuesIn(matcherNames()),
                         [](const auto& matcher) { return matcher.param; });

}  // namespace
}  // namespace omega_slam::matching

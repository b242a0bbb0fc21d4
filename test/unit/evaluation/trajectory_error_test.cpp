#include "omega_slam/evaluation/trajectory_error.h"

#include <gtest/gtest.h>

namespace omega_slam::evaluation {
namespace {

using geometry::Pose2;
using geometry::Trajectory;

TEST(TrajectoryError, ByHand) {
  // Two poses, 2 m apart in the estimate and 4 m in the truth: each is 1 m off after the best fit.
  const Trajectory estimate{{0.0, {0, 0, 0}}, {1.0, {2, 0, 0.25}}};
  const Trajectory truth{{0.0, {10, 10, 0}}, {1.0, {14, 10, 0}}};
  const TrajectoryError error = absoluteTrajectoryError(estimate, truth, 2.0);
  EXPECT_EQ(error.matched, 2U);
  EXPECT_NEAR(error.translation.mean, 1.0, 1e-12);
  EXPECT_NEAR(error.translation.max, 1.0, 1e-12);
  EXPECT_NEAR(error.rotation.max, 0.25, 1e-12);
  EXPECT_NEAR(error.T_truth_map.x, 11.0, 1e-12);
  EXPECT_NEAR(error.T_truth_map.y, 10.0, 1e-12);
}

TEST(TrajectoryError, TheTruthIsInterpolated) {
  const Trajectory truth{{1.0, {1, 0, 0}}, {0.0, {0, 0, 0}}, {2.0, {1, 1, 0}}};
  const Trajectory estimate{{0.25, {0.25, 0, 0}}, {1.0, {1, 0, 0}}, {1.5, {1, 0.5, 0}}};
  const TrajectoryError error = absoluteTrajectoryError(estimate, truth, 1.0);
  EXPECT_EQ(error.matched, 3U);
  EXPECT_NEAR(error.translation.max, 0.0, 1e-12);
}

TEST(TrajectoryError, OutsideAndInGapsTheTruthIsNotKnown) {
  const Trajectory truth{{1.0, {}}, {2.0, {}}, {9.0, {}}};
  const Trajectory estimate{{0.9, {}}, {1.0, {}}, {1.5, {}}, {5.0, {}}, {9.0, {}}, {9.1, {}}};
  const TrajectoryError error = absoluteTrajectoryError(estimate, truth, 1.0);
  EXPECT_EQ(error.matched, 3U);
  EXPECT_EQ(error.unmatched, 3U);
}

TEST(TrajectoryError, StandingStillIsAlignedByHeadings) {
  const Trajectory estimate{{0.0, {1, 1, 0.1}}, {1.0, {1, 1, 0.1}}};
  const Trajectory truth{{0.0, {-3, 4, 2.1}}, {1.0, {-3, 4, 2.1}}};
  const TrajectoryError error = absoluteTrajectoryError(estimate, truth, 1.0);
  EXPECT_NEAR(error.T_truth_map.theta, 2.0, 1e-9);
  EXPECT_NEAR(error.translation.max, 0.0, 1e-9);
  EXPECT_NEAR(error.rotation.max, 0.0, 1e-9);
}

TEST(TrajectoryError, NothingInCommon) {
  const TrajectoryError error = absoluteTrajectoryError({{5.0, {}}}, {});
  EXPECT_EQ(error.matched, 0U);
  EXPECT_EQ(error.unmatched, 1U);
  EXPECT_EQ(error.translation.mean, 0.0);
}

}  // namespace
}  // namespace omega_slam::evaluation

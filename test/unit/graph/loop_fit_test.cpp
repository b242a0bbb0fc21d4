#include "omega_slam/graph/loop_fit.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/graph/linearization.h"

namespace omega_slam::graph {
namespace {

using geometry::kPi;
using geometry::Pose2;

Constraint someLoop() {
  Constraint loop;
  loop.from = 0;
  loop.to = 1;
  loop.T_from_to = {1.0, 0.0, 0.5 * kPi};
  loop.information = Eigen::Vector3d(100.0, 25.0, 400.0).asDiagonal();
  loop.kind = ConstraintKind::kLoop;
  return loop;
}

TEST(LoopFitUnit, SpaceIsTheBoxOfTheMapAndAllHeadings) {
  EXPECT_DOUBLE_EQ(ErrorSpace::of({{-1.0, 2.0, 0.0}, {3.0, 5.0, 1.0}}).volume, 24.0 * kPi);
  EXPECT_DOUBLE_EQ(ErrorSpace::of({}).volume, 2.0 * kPi);
  EXPECT_DOUBLE_EQ(ErrorSpace::of({{1.0, 1.0, 0.0}}).volume, 2.0 * kPi)
      << "a square metre at least";
}

TEST(LoopFitUnit, ChanceIsTheShareOfTheEllipsoid) {
  const LoopFit fit{4.0, 0.001, true};
  EXPECT_NEAR(chanceOf(fit, {2.0}), 4.0 / 3.0 * kPi * 8.0 * 0.001 / 2.0, 1e-12);
  EXPECT_EQ(chanceOf({100.0, 1.0, true}, {2.0}), 1.0) << "no more than certain";
}

TEST(LoopFitUnit, OddsAreTheRatioOfTheDensities) {
  const LoopFit fit{2.0, 0.01, true};
  EXPECT_NEAR(oddsOf(fit, {3.0}), std::exp(-1.0) / std::pow(2.0 * kPi, 1.5) / 0.01 * 3.0, 1e-9);
  // Covariances that are four times too large: the same fit is two deviations off, not one.
  EXPECT_NEAR(oddsOf(fit, {3.0}, 0.25), oddsOf({8.0, 0.01 / 8.0, true}, {3.0}), 1e-9);
}

TEST(LoopFitUnit, ToPosesThatAreKnownIsChiSquare) {
  PoseGraph graph;
  graph.poses = {{}, {1.1, -0.2, 0.5 * kPi + 0.05}};
  const LoopFit fit = fitOfNewLoop(graph, someLoop(), Eigen::Matrix3d::Zero());
  EXPECT_TRUE(fit.is_testable);
  EXPECT_NEAR(fit.squared, chiSquare(graph, someLoop()), 1e-12);
  EXPECT_NEAR(fit.spread, 0.1 * 0.2 * 0.05, 1e-12);
}

TEST(LoopFitUnit, PredictionIsTurnedIntoTheLoopsAxes) {
  // The loop measures along an axis that is turned by 30 degrees. There alone the prediction is
  // vague, and there alone it is off.
  Constraint loop = someLoop();
  loop.T_from_to.theta = kPi / 6.0;
  const Eigen::Vector2d along(std::cos(kPi / 6.0), std::sin(kPi / 6.0));
  PoseGraph graph;
  graph.poses = {{}, {1.0 + 0.3 * along.x(), 0.3 * along.y(), kPi / 6.0}};
  Eigen::Matrix3d prediction = Eigen::Matrix3d::Zero();
  prediction.topLeftCorner<2, 2>() = 0.08 * along * along.transpose();
  const LoopFit fit = fitOfNewLoop(graph, loop, prediction);
  EXPECT_NEAR(fit.squared, 0.3 * 0.3 / (0.01 + 0.08), 1e-12);
  EXPECT_NEAR(fit.spread, 0.3 * 0.2 * 0.05, 1e-12);
}

TEST(LoopFitUnit, NothingIsKnownOfTheOnlyTie) {
  const Constraint loop = someLoop();
  const LoopFit fit = fitOf(loop, {0.0, 0.0, 0.0}, loop.information.inverse(), true);
  EXPECT_FALSE(fit.is_testable);
  EXPECT_EQ(chanceOf(fit, {1.0}), 1.0);
  EXPECT_EQ(oddsOf(fit, {1.0}), 1.0);
}

}  // namespace
}  // namespace omega_slam::graph

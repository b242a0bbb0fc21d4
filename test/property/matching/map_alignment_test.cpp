#include "omega_slam/matching/map_alignment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

struct Scene {
  LocalMap map;
  Points scan;  // taken at the origin of the map
};

Scene furnishedScene(std::mt19937_64& random) {
  const Points points = test::measurePoints(test::furnishedRoom(), {}, 360, 0.02, random);
  return {LocalMap({}, {{points, {0.0, 0.0}}}), points};
}

double squaredResiduals(const Scene& scene, std::size_t level, const Eigen::Vector3d& pose) {
  return linearize(scene.map, level, scene.scan, Pose2::fromVector(pose)).squared_residuals;
}

TEST(MapAlignmentLaws, DescentIsTheDerivativeOfTheSquares) {
  constexpr double kStep = 1e-7;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Scene scene = furnishedScene(random);
    for (std::size_t level = 0; level < scene.map.grids().size(); ++level) {
      const Eigen::Vector3d pose = test::randomPose(0.1, 0.05, random).vector();
      const MapLinearization here =
          linearize(scene.map, level, scene.scan, Pose2::fromVector(pose));
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d nudge = kStep * Eigen::Vector3d::Unit(axis);
        const double ahead =
            (squaredResiduals(scene, level, pose + nudge) - here.squared_residuals) / kStep;
        const double behind =
            (here.squared_residuals - squaredResiduals(scene, level, pose - nudge)) / kStep;
        // sum of (1 - M)^2 falls by twice J^T r; where a point crosses a border the slope jumps,
        // and is either that before or that behind it.
        const double slope = -2.0 * here.descent[axis];
        const double error = std::min(std::abs(slope - ahead), std::abs(slope - behind));
        EXPECT_LT(error, 3e-3 * std::abs(slope) + 0.1) << "level " << level << ", axis " << axis;
      }
    }
  }
}

TEST(MapAlignmentLaws, JacobianOfEachPointMakesTheHessian) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Scene scene = furnishedScene(random);
    const Pose2 pose = test::randomPose(0.1, 0.05, random);
    for (std::size_t level = 0; level < scene.map.grids().size(); ++level) {
      Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
      for (const Eigen::Vector2d& point : scene.scan) {
        const MapLinearization one = linearize(scene.map, level, {point}, pose);
        // Of a single point: descent = J^T r and squared_residuals = r^2.
        if (one.squared_residuals > 0.0) {
          hessian += one.descent * one.descent.transpose() / one.squared_residuals;
        }
      }
      const MapLinearization all = linearize(scene.map, level, scene.scan, pose);
      EXPECT_LT((all.hessian - hessian).norm(), 1e-9 * hessian.norm()) << level;
      EXPECT_GT(hessian.norm(), 100.0);
    }
  }
}

TEST(MapAlignmentLaws, ValueIsInterpolatedBetweenCentres) {
  LocalMapConfig config;
  config.resolution = 0.1;
  config.levels = 1;
  const LocalMap map(config, {{{{1.05, 0.05}}, {0.0, 0.0}}});
  const auto valueAt = [&map](double x, double y) {
    return 1.0 - std::sqrt(linearize(map, 0, {{x, y}}, {}).squared_residuals);
  };
  const double most = valueAt(1.05, 0.05);
  EXPECT_NEAR(most, std::tanh(1.1), 0.01) << "a single return";
  EXPECT_NEAR(valueAt(1.10, 0.05), 0.5 * most, 1e-9);
  EXPECT_NEAR(valueAt(1.05, 0.125), 0.25 * most, 1e-9);
  EXPECT_NEAR(valueAt(1.10, 0.10), 0.25 * most, 1e-9);
  EXPECT_EQ(valueAt(1.15, 0.05), 0.0);
  EXPECT_EQ(valueAt(500.0, 0.05), 0.0) << "outside of the map";
}

TEST(MapAlignmentLaws, NeverEndsWorseThanItBeganOnAGridOfOneLevel) {
  LocalMapConfig config;
  config.levels = 1;
  config.resolution = 0.1;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Points points = test::measurePoints(test::furnishedRoom(), {}, 360, 0.02, random);
    const LocalMap map(config, {{points, {0.0, 0.0}}});
    for (int i = 0; i < 50; ++i) {
      const Pose2 guess = test::randomPose(0.5, 0.3, random);
      const Pose2 found = alignToMap(map, points, guess, 20).T_map_scan;
      // The last step is too small to be looked at: of 100 seeds, two end worse by some 5e-6.
      EXPECT_LE(linearize(map, 0, points, found).squared_residuals,
                (1.0 + 1e-5) * linearize(map, 0, points, guess).squared_residuals)
          << i;
    }
  }
}

TEST(MapAlignmentLaws, WithoutIterationsTheGuessStands) {
  std::mt19937_64 random(1);
  const Scene scene = furnishedScene(random);
  const Pose2 guess{0.05, 0.02, 0.01};
  const MapAlignment alignment = alignToMap(scene.map, scene.scan, guess, 0);
  EXPECT_EQ(alignment.T_map_scan.vector(), guess.vector());
  EXPECT_FALSE(alignment.converged);
}

TEST(MapAlignmentLaws, OnAnEmptyMapTheGuessStands) {
  const Points points(40, {1.0, 1.0});
  const Pose2 guess{0.3, -0.2, 0.5};
  EXPECT_LT(
      test::gapBetween(alignToMap(LocalMap(), points, guess, 20).T_map_scan, guess).translation,
      1e-12);
}

TEST(MapAlignmentLaws, CorridorKeepsTheGuessAlongIt) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    Reference views;
    for (const double x : {-1.0, -0.5, 0.0}) {
      const View view{
          test::measurePoints(test::endlessCorridor(), {x, 0.0, 0.0}, 360, 0.01, random),
          {0.0, 0.0}};
      views.push_back(transformed({x, 0.0, 0.0}, view));
    }
    const LocalMap map({}, views);
    const Points scan =
        test::measurePoints(test::endlessCorridor(), {0.3, 0.0, 0.0}, 360, 0.01, random);
    const Pose2 found = alignToMap(map, scan, {0.4, 0.05, 0.03}, 20).T_map_scan;
    // Of 100 seeds, noise leads it astray by 0.09 m at most.
    EXPECT_NEAR(found.x, 0.4, 0.1) << "next to nothing says where along the corridor";
    EXPECT_NEAR(found.y, 0.0, 0.01);
    EXPECT_NEAR(found.theta, 0.0, 0.005);
  }
}

}  // namespace
}  // namespace omega_slam::matching

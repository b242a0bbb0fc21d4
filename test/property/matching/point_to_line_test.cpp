#include "omega_slam/matching/point_to_line.h"

#include <gtest/gtest.h>

#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

/// Cauchy's cost of all distances, in units of the range's variance.
double costAt(SurfaceModel& model, const Points& scan, const Pose2& pose,
              const DistanceKernel& kernel) {
  const double tolerance = kernel.tolerance * kernel.tolerance;
  double cost = 0.0;
  for (const auto& p_scan : scan) {
    const Eigen::Vector2d place = pose * p_scan;
    if (const auto partner = model.partnerOf(place, kernel.reach)) {
      const Eigen::Vector2d gap = place - partner->point;
      const double squared = partner->surface.isLine()
                                 ? std::pow(partner->surface.normal.dot(gap), 2)
                                 : 0.5 * gap.squaredNorm();
      cost += 0.5 * tolerance * std::log1p(squared / tolerance);
    }
  }
  return cost / (kernel.deviation * kernel.deviation);
}

/// A corner of a room with two table legs.
Points smallScene(std::mt19937_64& random) {
  std::normal_distribution<double> noise(0.0, 0.005);
  Points points;
  for (int i = 0; i < 30; ++i) {
    points.emplace_back(2.0 + noise(random), -1.0 + 0.05 * i);
  }
  for (int i = 0; i < 30; ++i) {
    points.emplace_back(1.4 - 0.05 * i, 0.9 + noise(random));
  }
  for (int i = 0; i < 8; ++i) {
    points.emplace_back(0.5 + noise(random), (i < 4 ? 0.4 : -0.4) + noise(random));
  }
  return points;
}

TEST(SurfaceModelLaws, PointsAskedForAgainHaveThePartnersOfNewOnes) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Points reference = smallScene(random);
    const Points scan = smallScene(random);
    SurfaceModel remembering({View{reference}});
    int partners = 0;
    for (int step = 0; step < 60; ++step) {
      const double size = step % 3 == 0 ? 0.3 : 0.01;  // now and then far, mostly near by
      const double reach = step % 5 == 0 ? 0.4 : 0.1;
      const Pose2 pose = test::randomPose(size, size, random);
      SurfaceModel forgetful({View{reference}});
      for (std::size_t i = 0; i < scan.size(); ++i) {
        const auto* again = remembering.partnerOf(i, pose * scan[i], reach);
        const auto anew = forgetful.partnerOf(pose * scan[i], reach);
        ASSERT_EQ(again != nullptr, anew.has_value());
        if (again != nullptr) {
          EXPECT_EQ(again->point, anew->point);
          ++partners;
        }
      }
    }
    EXPECT_GT(partners, 1000);
    EXPECT_LT(partners, 60 * static_cast<int>(scan.size()));
  }
}

TEST(PointToLineLaws, GradientAgreesWithDifferencesOfTheCost) {
  const DistanceKernel kernel{0.3, 0.02, 0.05};
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Points reference = smallScene(random);
    const Points scan = smallScene(random);
    SurfaceModel model({View{reference}});
    for (int i = 0; i < 20; ++i) {
      const Pose2 pose = test::randomPose(0.05, 0.05, random);
      const PointToLineEquations equations = linearize(model, View{scan}, pose, kernel);
      for (int k = 0; k < 3; ++k) {
        constexpr double kDelta = 1e-7;
        const Eigen::Vector3d delta = kDelta * Eigen::Vector3d::Unit(k);
        const double slope =
            (costAt(model, scan, Pose2::fromVector(pose.vector() + delta), kernel) -
             costAt(model, scan, Pose2::fromVector(pose.vector() - delta), kernel)) /
            (2.0 * kDelta);
        EXPECT_NEAR(-equations.vector[k], slope, 1e-4 * equations.vector.norm()) << i << ' ' << k;
      }
    }
  }
}

TEST(PointToLineLaws, MatrixAgreesWithDifferencesOfTheDistances) {
  const DistanceKernel kernel{0.3, 0.02, 1e9};  // all weights are one
  std::mt19937_64 random(5);
  const Points reference = smallScene(random);
  const Points scan = smallScene(random);
  SurfaceModel model({View{reference}});
  const Pose2 pose{0.02, -0.03, 0.04};
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  for (const auto& p_scan : scan) {
    const auto partner = model.partnerOf(pose * p_scan, kernel.reach);
    ASSERT_TRUE(partner);
    Eigen::Matrix<double, 2, 3> slopes;
    for (int k = 0; k < 3; ++k) {
      constexpr double kDelta = 1e-6;
      const Eigen::Vector3d delta = kDelta * Eigen::Vector3d::Unit(k);
      slopes.col(k) = (Pose2::fromVector(pose.vector() + delta) * p_scan -
                       Pose2::fromVector(pose.vector() - delta) * p_scan) /
                      (2.0 * kDelta);
    }
    expected += slopes.transpose() * partner->surface.information() * slopes;
  }
  expected /= kernel.deviation * kernel.deviation;
  const Eigen::Matrix3d matrix = linearize(model, View{scan}, pose, kernel).matrix;
  EXPECT_LT((matrix - expected).norm(), 1e-6 * expected.norm());
}

TEST(PointToLineLaws, SomeOfThePointsSayWhatTheySayAlone) {
  const DistanceKernel kernel{0.3, 0.02, 0.1};
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Reference reference{View{smallScene(random)}};
    const View scan{smallScene(random)};
    const SomePoints some = someOf(scan, 20);
    View alone;
    for (std::size_t i = 0; i < scan.points.size(); i += some.stride) {
      alone.points.push_back(scan.points[i]);
    }
    EXPECT_LE(alone.points.size(), 20U);
    EXPECT_GT(alone.points.size(), 10U);
    SurfaceModel model(reference);
    SurfaceModel another(reference);
    for (int i = 0; i < 5; ++i) {
      const Pose2 pose = test::randomPose(0.1, 0.1, random);
      const auto of_some = linearize(model, some, pose, kernel);
      const auto of_all = linearize(another, alone, pose, kernel);
      EXPECT_EQ(of_some.matrix, of_all.matrix);
      EXPECT_EQ(of_some.vector, of_all.vector);
    }
  }
}

TEST(PointToLineLaws, OpenDirectionLeadsBackToTheGuess) {
  PointToLineEquations equations;
  equations.matrix.diagonal() = Eigen::Vector3d(1e3, 1e6, 1e6);
  equations.vector = {500.0, 2e4, 1e4};
  equations.certain = equations.matrix;
  const Pose2 pose{1.0, 2.0, 3.1};
  const Pose2 guess{1.3, 2.5, -3.1};
  const Eigen::Vector3d free = stepToLeastSquares(equations, pose, guess);
  EXPECT_LT((free - Eigen::Vector3d(0.5, 0.02, 0.01)).norm(), 1e-9);
  equations.certain(0, 0) = -1e5;
  const Eigen::Vector3d held = stepToLeastSquares(equations, pose, guess);
  EXPECT_LT((held - Eigen::Vector3d(0.3, 0.02, 0.01)).norm(), 1e-4);
  equations.certain.setZero();
  const Eigen::Vector3d all_held = stepToLeastSquares(equations, pose, guess);
  EXPECT_LT((all_held - Eigen::Vector3d(0.3, 0.5, 2.0 * geometry::kPi - 6.2)).norm(), 1e-3);
}

TEST(PointToLineLaws, ReachesTheTruthThatPointsAloneMiss) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
      const Pose2 place = test::randomPose(0.8, 3.1, random);
      const Points reference = test::measurePoints(test::furnishedRoom(), place, 360, 0.0, random);
      const Pose2 truth = test::randomPose(0.3, 0.3, random);
      Points scan;
      for (const auto& p : reference) {
        scan.push_back(truth.inverse() * p);
      }
      SurfaceModel model({View{reference}});
      const Eigen::Vector2d origin = truth.inverse().translation();
      const Pose2 guess = truth * test::randomPose(0.03, 0.015, random);
      const auto gap =
          test::gapBetween(refinePointToLine(model, View{scan, origin}, guess, {}), truth);
      EXPECT_LT(gap.translation, 2e-3) << i;
      EXPECT_LT(gap.rotation, 1e-3) << i;
    }
  }
}

TEST(PointToLineLaws, CorridorKeepsTheGuessAlongIt) {
  std::mt19937_64 random(3);
  const Points reference = test::measurePoints(test::endlessCorridor(), {}, 360, 0.0, random);
  SurfaceModel model({View{reference}});
  const Pose2 found = refinePointToLine(model, View{reference}, {0.07, 0.05, 0.01}, {});
  EXPECT_NEAR(found.x, 0.07, 0.01);
  EXPECT_NEAR(found.y, 0.0, 1e-3);
  EXPECT_NEAR(found.theta, 0.0, 1e-3);
}

TEST(PointToLineLaws, OtherSideOfAThinWallDoesNotPull) {
  Points wall;
  for (int i = 0; i < 100; ++i) {
    wall.emplace_back(-1.0 + 0.02 * i, 2.0);
  }
  SurfaceModel model({View{wall}});
  const Pose2 guess{0.0, 0.05, 0.0};
  const auto seen_from = [&](double y) { return View{wall, {0.0, y}}; };
  EXPECT_LT(refinePointToLine(model, seen_from(0.0), guess, {}).y, 0.001);
  EXPECT_EQ(refinePointToLine(model, seen_from(4.0), guess, {}).y, guess.y);
}

TEST(PointToLineLaws, WithNothingInReachTheGuessStands) {
  std::mt19937_64 random(3);
  const Points room = test::measurePoints(test::furnishedRoom(), {}, 90, 0.0, random);
  SurfaceModel model({View{room}});
  const Pose2 far{30.0, 1.0, 0.5};
  EXPECT_LT(test::gapBetween(refinePointToLine(model, View{room}, far, {}), far).translation, 1e-9);
  const Points none;
  SurfaceModel empty({View{none}});
  EXPECT_LT(test::gapBetween(refinePointToLine(empty, View{room}, far, {}), far).translation, 1e-9);
}

}  // namespace
}  // namespace omega_slam::matching

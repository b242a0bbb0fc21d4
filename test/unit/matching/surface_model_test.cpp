#include "omega_slam/matching/surface_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace omega_slam::matching {
namespace {

/// A wall along x at height `y`, from `first` on.
Points wall(double first, double y, double spacing, int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(first + spacing * i, y);
  }
  return points;
}

SurfaceModel::Partner partnerAt(const Points& points, const Eigen::Vector2d& place,
                                double reach = 0.1) {
  SurfaceModel model({View{points}});
  const auto partner = model.partnerOf(place, reach);
  EXPECT_TRUE(partner.has_value());
  return partner.value_or(SurfaceModel::Partner{});
}

TEST(SurfaceModelTest, WallIsALine) {
  const auto partner = partnerAt(wall(-1.0, 2.0, 0.02, 100), {0.3, 2.05});
  ASSERT_TRUE(partner.surface.isLine());
  EXPECT_NEAR(std::abs(partner.surface.normal.y()), 1.0, 1e-12);
  EXPECT_NEAR(partner.point.y(), 2.0, 1e-12);
}

TEST(SurfaceModelTest, WallUprightIsALine) {
  Points points = wall(-1.0, 2.0, 0.02, 100);
  for (auto& point : points) {
    std::swap(point.x(), point.y());
  }
  EXPECT_NEAR(std::abs(partnerAt(points, {2.05, 0.3}).surface.normal.x()), 1.0, 1e-12);
}

TEST(SurfaceModelTest, OutOfReachThereIsNoPartner) {
  const Points points = wall(-1.0, 2.0, 0.02, 100);
  SurfaceModel model({View{points}});
  EXPECT_FALSE(model.partnerOf({0.0, 2.2}, 0.1));
  EXPECT_TRUE(model.partnerOf({0.0, 2.2}, 0.21));
}

TEST(SurfaceModelTest, NormalPointsToWhereTheWallWasSeenFrom) {
  const Points points = wall(-1.0, 2.0, 0.02, 100);
  for (const double eye : {-1.0, 5.0}) {
    SurfaceModel model({View{points, {0.0, eye}}});
    const auto partner = model.partnerOf({0.3, 2.05}, 0.1);
    ASSERT_TRUE(partner);
    EXPECT_NEAR(partner->surface.normal.y(), eye < 2.0 ? -1.0 : 1.0, 1e-12);
    EXPECT_TRUE(partner->isSeenFrom({-3.0, eye}));
    EXPECT_FALSE(partner->isSeenFrom({-3.0, 4.0 - eye})) << "from behind the wall";
    EXPECT_TRUE(partner->isSeenFrom({-3.0, 2.0})) << "edge-on nobody can tell";
  }
}

TEST(SurfaceModelTest, EachViewHasAnEyeOfItsOwn) {
  SurfaceModel model({View{wall(-1.0, 2.0, 0.02, 50), {0.0, 0.0}}, View{},
                      View{wall(-1.0, 2.2, 0.02, 50), {0.0, 5.0}}});
  EXPECT_LT(model.partnerOf({0.0, 2.0}, 0.1)->surface.normal.y(), 0.0);
  EXPECT_GT(model.partnerOf({0.0, 2.2}, 0.1)->surface.normal.y(), 0.0);
}

TEST(SurfaceModelTest, SpotsAreSeenFromAllAround) {
  const auto partner = partnerAt(Points(10, {1.0, 1.0}), {1.0, 1.0});
  EXPECT_TRUE(partner.isSeenFrom({5.0, 5.0}));
  EXPECT_TRUE(partner.isSeenFrom({-5.0, 0.0}));
}

TEST(SurfaceModelTest, SlopeVarianceIsThatOfManyFits) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0.0, 0.02);
  double squared_slopes = 0.0;
  double variances = 0.0;
  for (int i = 0; i < 2000; ++i) {
    Points points = wall(-0.29, 0.0, 0.05, 12);
    for (auto& point : points) {
      point.y() += noise(random);
    }
    const Surface surface = partnerAt(points, {0.01, 0.0}).surface;
    squared_slopes += std::pow(surface.normal.x() / surface.normal.y(), 2);
    variances += surface.slope_variance;
  }
  EXPECT_NEAR(variances / squared_slopes, 1.0, 0.1);
}

TEST(SurfaceModelTest, ThreePointsInLineAreNotTakenForExact) {
  const Surface surface = partnerAt(wall(0.0, 2.0, 0.2, 3), {0.2, 2.0}).surface;
  EXPECT_NEAR(surface.slope_variance, 1e-4 / 0.08, 1e-12);
}

TEST(SurfaceModelTest, JumpOfRangeEndsTheSurface) {
  Points points = wall(-1.0, 1.0, 0.02, 50);
  const Points behind = wall(0.05, 1.4, 0.02, 50);
  points.insert(points.end(), behind.begin(), behind.end());
  const auto edge = partnerAt(points, {-0.02, 1.0});
  EXPECT_NEAR(std::abs(edge.surface.normal.y()), 1.0, 1e-12);
  EXPECT_NEAR(edge.point.y(), 1.0, 1e-12);
}

TEST(SurfaceModelTest, OrderMayBeMissing) {
  Points points = wall(-1.0, 2.0, 0.05, 41);
  std::shuffle(points.begin(), points.end(), std::mt19937_64(3));
  SurfaceModel model({View{points}});
  int lines = 0;
  for (const auto& point : points) {
    lines += model.partnerOf(point, 0.1)->surface.isLine() ? 1 : 0;
  }
  EXPECT_EQ(lines, 41);
}

TEST(SurfaceModelTest, TwoViewsOfAFarWallMakeALine) {
  Points points = wall(0.0, 8.0, 0.2, 10);
  const Points again = wall(0.1, 8.0, 0.2, 10);
  points.insert(points.end(), again.begin(), again.end());
  EXPECT_TRUE(partnerAt(points, {1.0, 8.0}).surface.isLine());
}

TEST(SurfaceModelTest, FarWallIsALineThroughItsNeighbours) {
  EXPECT_TRUE(partnerAt(wall(0.0, 8.0, 0.6, 5), {1.2, 8.0}).surface.isLine());
  EXPECT_FALSE(partnerAt(wall(0.0, 8.0, 0.6, 5), {0.0, 8.0}).surface.isLine()) << "at its end";
  EXPECT_FALSE(partnerAt(wall(0.0, 8.0, 1.6, 5), {3.2, 8.0}).surface.isLine()) << "too far apart";
  const Points bent{{0.0, 8.0}, {0.6, 8.2}, {1.2, 8.0}};
  EXPECT_FALSE(partnerAt(bent, {0.6, 8.2}).surface.isLine());
  const Points uneven{{0.0, 8.0}, {0.4, 8.0}, {1.4, 8.0}};
  EXPECT_FALSE(partnerAt(uneven, {0.4, 8.0}).surface.isLine());
}

TEST(SurfaceModelTest, TableLegIsASpot) {
  const Points leg{{1.0, 1.0}, {1.01, 1.03}, {0.99, 1.02}, {1.03, 1.0}};
  const auto partner = partnerAt(leg, {0.99, 0.99});
  EXPECT_TRUE(partner.surface.is_spot);
  EXPECT_FALSE(partner.surface.isLine());
  EXPECT_EQ(partner.point, leg[0]);
}

TEST(SurfaceModelTest, RaggedHeapIsNeither) {
  const Points heap{{1.0, 1.0}, {1.15, 1.15}, {0.85, 1.15}, {1.15, 0.85}, {0.85, 0.85}};
  const auto partner = partnerAt(heap, {1.0, 1.0});
  EXPECT_FALSE(partner.surface.is_spot);
  EXPECT_FALSE(partner.surface.isLine());
}

TEST(SurfaceModelTest, OnePlaceManyTimes) {
  const auto partner = partnerAt(Points(100, {1.0, 1.0}), {1.0, 1.0});
  EXPECT_FALSE(partner.surface.isLine());
  EXPECT_TRUE(partner.surface.is_spot);
}

TEST(SurfaceInformation, LineIsFreeAlongItself) {
  const Surface line{{0.6, 0.8}, 0.01, false};
  const Eigen::Vector2d tangent(-0.8, 0.6);
  EXPECT_NEAR(line.normal.dot(line.information() * line.normal), 1.0, 1e-12);
  EXPECT_NEAR((line.information() * tangent).norm(), 0.0, 1e-12);
  // Of a pure shift: certain across, and along less than nothing, by three times the variance.
  const Eigen::Matrix2d certain = certainInformation(line, {0.0, 0.0}).topLeftCorner<2, 2>();
  EXPECT_NEAR(line.normal.dot(certain * line.normal), 1.0, 1e-12);
  EXPECT_NEAR(tangent.dot(certain * tangent), -0.03, 1e-12);
}

TEST(SurfaceInformation, LineAcrossAStepKnowsNothingAlongABareWall) {
  const Surface tilted{{std::sin(0.1), std::cos(0.1)}, 1e-4, false};
  const auto along = [&](const Eigen::Vector2d& facing) {
    return certainInformation(tilted, {0.0, 0.0}, facing)(0, 0);
  };
  EXPECT_GT(along({0.0, 0.0}), 0.009);
  EXPECT_GT(along(tilted.normal), 0.009) << "the same step";
  EXPECT_LT(along({0.0, 1.0}), 0.0) << "a bare wall";
}

TEST(SurfaceInformation, SpotCountsHalfAndRaggedPointsAreNotToBeBuiltOn) {
  const Surface spot{{0.0, 0.0}, 0.0, true};
  EXPECT_TRUE(spot.information().isApprox(0.5 * Eigen::Matrix2d::Identity()));
  const Eigen::Vector2d arm(0.3, -0.2);
  EXPECT_TRUE(certainInformation(spot, arm).isApprox(poseInformation(spot.information(), arm)));
  const Surface ragged;
  EXPECT_TRUE(ragged.information().isApprox(spot.information()));
  EXPECT_TRUE(certainInformation(ragged, arm).isZero());
}

}  // namespace
}  // namespace omega_slam::matching

#include "omega_slam/matching/surface_field.h"

#include <gtest/gtest.h>

namespace omega_slam::matching {
namespace {

constexpr double kReach = 0.1;

/// A wall along y at x = 1, seen from the origin.
SurfaceField wallField() {
  View view;
  for (int i = -20; i <= 20; ++i) {
    view.points.emplace_back(1.0, 0.05 * i);
  }
  return {traceSurfaces({view}, 0.04), kReach};
}

TEST(SurfaceFieldTest, DistanceIsExactWhereverInACellThePlaceIs) {
  const SurfaceField field = wallField();
  const Eigen::Vector2d unknown(0.0, 0.0);
  for (double x = 0.92; x < 1.09; x += 0.003) {
    const auto partner = field.partnerOf({x, 0.123}, unknown);
    ASSERT_TRUE(partner) << x;
    const double distance = partner->surface.normal.dot(Eigen::Vector2d(x, 0.123) - partner->point);
    EXPECT_NEAR(distance, 1.0 - x, 1e-9);
  }
}

TEST(SurfaceFieldTest, BeyondItsReachThereIsNoPartner) {
  const SurfaceField field = wallField();
  EXPECT_FALSE(field.partnerOf({0.89, 0.0}, {0.0, 0.0}));
  EXPECT_FALSE(field.partnerOf({1.0, 1.2}, {0.0, 0.0}));
  EXPECT_FALSE(field.partnerOf({500.0, -500.0}, {0.0, 0.0}));
}

TEST(SurfaceFieldTest, TheOtherSideOfAWallIsNoPartner) {
  const SurfaceField field = wallField();
  EXPECT_TRUE(field.partnerOf({1.05, 0.0}, {-1.0, 0.0}));
  EXPECT_FALSE(field.partnerOf({1.05, 0.0}, {1.0, 0.0}));
  EXPECT_FALSE(field.partnerOf({1.05, 0.0}, {0.0, 1.0})) << "nor is a wall that crosses";
}

TEST(SurfaceFieldTest, AReturnOnItsOwnIsAPartnerFromAnySide) {
  const SurfaceField field(traceSurfaces({View{{{1.0, 0.0}}, {0.0, 0.0}}}, 0.04), kReach);
  const auto partner = field.partnerOf({1.03, 0.04}, {1.0, 0.0});
  ASSERT_TRUE(partner);
  EXPECT_EQ(partner->point, Eigen::Vector2d(1.0, 0.0));
  EXPECT_FALSE(partner->surface.isLine());
}

TEST(SurfaceFieldTest, WithoutSurfacesThereIsNoPartner) {
  EXPECT_FALSE(SurfaceField({}, kReach).partnerOf({0.0, 0.0}, {0.0, 0.0}));
}

}  // namespace
}  // namespace omega_slam::matching

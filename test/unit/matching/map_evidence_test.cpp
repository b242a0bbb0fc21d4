#include "omega_slam/matching/map_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr double kReach = 0.1;

/// A wall along x, 2 m ahead of the laser, in the middle of a row of 5 cm, the cells of which are
/// looked at for this reach.
Points wall() {
  Points points;
  for (int i = -50; i <= 50; ++i) {
    points.emplace_back(0.02 * i, 2.025);
  }
  return points;
}

LocalMap mapOfTheWall() { return {{}, {{wall(), {0.0, 0.0}}}}; }

TEST(MapEvidence, ResidualIsTheDistanceFromTheWall) {
  const LocalMap map = mapOfTheWall();
  const MatchEvidence at_rest = gatherEvidence(map, wall(), {}, kReach);
  EXPECT_EQ(at_rest.points, wall().size());
  EXPECT_EQ(at_rest.partners, wall().size());
  EXPECT_LT(std::sqrt(at_rest.squared_residuals / 101.0), 0.003);
  for (const double offset : {-0.05, -0.03, 0.02, 0.05}) {
    const MatchEvidence moved = gatherEvidence(map, wall(), {0.0, offset, 0.0}, kReach);
    EXPECT_NEAR(std::sqrt(moved.squared_residuals / static_cast<double>(moved.partners)),
                std::abs(offset), 0.003)
        << offset;
  }
}

TEST(MapEvidence, PartnersAreWithinReach) {
  const LocalMap map = mapOfTheWall();
  EXPECT_EQ(gatherEvidence(map, wall(), {0.0, 0.2, 0.0}, kReach).partners, 0U);
  const std::size_t beside = gatherEvidence(map, wall(), {1.0, 0.0, 0.0}, kReach).partners;
  EXPECT_NEAR(static_cast<double>(beside), 56.0, 4.0) << "half of the wall, and the reach";
}

TEST(MapEvidence, WallSaysNothingOfTheWayAlongIt) {
  const MatchEvidence evidence = gatherEvidence(mapOfTheWall(), wall(), {}, kReach);
  EXPECT_GT(evidence.hessian(1, 1), 80.0);
  EXPECT_LT(evidence.hessian(0, 0), 0.05 * evidence.hessian(1, 1));
}

TEST(MapEvidence, OutsideOfTheMapThereIsNone) {
  const LocalMap map = mapOfTheWall();
  for (const Pose2& pose : {Pose2{100.0, 0.0, 0.0}, {-1e9, 0.0, 0.0}, {0.0, 1e300, 0.0}}) {
    EXPECT_EQ(gatherEvidence(map, wall(), pose, kReach).partners, 0U);
  }
  EXPECT_EQ(gatherEvidence(LocalMap(), wall(), {}, kReach).partners, 0U);
}

}  // namespace
}  // namespace omega_slam::matching

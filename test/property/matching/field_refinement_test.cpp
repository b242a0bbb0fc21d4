#include "omega_slam/matching/field_refinement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr double kNoise = 0.02;
constexpr DistanceKernel kKernel{0.1, kNoise, 0.04};

SurfaceField fieldOf(const Points& points) {
  return {traceSurfaces({View{points, {0.0, 0.0}}}, 0.04), 0.1};
}

/// What the steps make small: Cauchy's cost of a return's distance from its surface. None where it
/// has no partner that pulls.
std::optional<double> costOf(const SurfaceField& field, const SurfacePatch& patch,
                             const Pose2& pose) {
  const Eigen::Vector2d place = pose * patch.hit;
  const auto partner = field.partnerOf(place, pose.rotation() * patch.surface.normal);
  if (!partner || !(partner->surface.isLine() || partner->surface.is_spot)) {
    return std::nullopt;
  }
  const Eigen::Vector2d gap = place - partner->point;
  const double squared = gap.dot(partner->surface.information() * gap);
  const double squared_tolerance = kKernel.tolerance * kKernel.tolerance;
  return 0.5 * squared_tolerance * std::log(1.0 + squared / squared_tolerance) / (kNoise * kNoise);
}

TEST(FieldRefinementLaws, EquationsAreTheSlopeOfTheCost) {
  int compared = 0;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Points points = test::measurePoints(test::furnishedRoom(), {}, 360, 0.01, random);
    const SurfaceField field = fieldOf(points);
    const Pose2 pose = test::randomPose(0.05, 0.02, random);
    for (const SurfacePatch& patch : tracePatches({points, {0.0, 0.0}})) {
      const std::vector<SurfacePatch> scan{patch};
      const Eigen::Vector3d slope = FieldRefinement(field, scan).linearize(pose, kKernel).vector;
      for (int axis = 0; axis < 3; ++axis) {
        constexpr double kStep = 1e-6;
        const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
        const auto after = costOf(field, patch, Pose2::fromVector(pose.vector() + step));
        const auto before = costOf(field, patch, Pose2::fromVector(pose.vector() - step));
        // Between two patches the cost has a step.
        if (after && before && std::abs(*after - *before) < 1e-2) {
          EXPECT_NEAR((*before - *after) / (2.0 * kStep), slope[axis], 1e-3 + 1e-5 * slope.norm());
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 1500);
}

TEST(FieldRefinementLaws, ReachesTheTruthFromCentimetresAway) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20; ++i) {
      const Pose2 place = test::randomPose(0.8, 3.1, random);
      const Points reference = test::measurePoints(test::furnishedRoom(), place, 360, 0.0, random);
      const Pose2 truth = test::randomPose(0.3, 0.3, random);
      const auto scan = tracePatches(transformed(truth.inverse(), {reference, {0.0, 0.0}}));
      const SurfaceField field = fieldOf(reference);
      const Pose2 start = truth * test::randomPose(0.03, 0.02, random);
      const auto refined = FieldRefinement(field, scan).refine(start, start, kNoise, 20);
      const auto gap = test::gapBetween(refined.T_reference_scan, truth);
      EXPECT_LT(gap.translation, 1e-3) << i;
      EXPECT_LT(gap.rotation, 5e-4) << i;
      EXPECT_TRUE(refined.converged) << i;
    }
  }
}

TEST(FieldRefinementLaws, CorridorLeadsBackToWhereItIsHeld) {
  std::mt19937_64 random(3);
  const Points reference = test::measurePoints(test::endlessCorridor(), {}, 360, 0.0, random);
  const SurfaceField field = fieldOf(reference);
  const auto scan = tracePatches({reference, {0.0, 0.0}});
  const auto refined =
      FieldRefinement(field, scan).refine({0.07, 0.05, 0.01}, {0.2, -0.03, 0.0}, kNoise, 20);
  EXPECT_NEAR(refined.T_reference_scan.x, 0.2, 0.005);
  EXPECT_NEAR(refined.T_reference_scan.y, 0.0, 1e-3);
  EXPECT_NEAR(refined.T_reference_scan.theta, 0.0, 1e-3);
}

TEST(FieldRefinementLaws, WithNothingInReachTheStartStands) {
  std::mt19937_64 random(3);
  const Points room = test::measurePoints(test::furnishedRoom(), {}, 90, 0.0, random);
  const SurfaceField field = fieldOf(room);
  const auto scan = tracePatches({room, {0.0, 0.0}});
  const Pose2 far{30.0, 1.0, 0.5};
  const FieldRefinement refinement(field, scan);
  EXPECT_LT(
      test::gapBetween(refinement.refine(far, far, kNoise, 20).T_reference_scan, far).translation,
      1e-9);
  EXPECT_EQ(refinement.evidence(far).partners, 0U);
}

TEST(FieldRefinementLaws, EvidenceCountsWhatHasAPartner) {
  std::mt19937_64 random(3);
  const Points room = test::measurePoints(test::furnishedRoom(), {}, 360, 0.0, random);
  const SurfaceField field = fieldOf(room);
  const auto scan = tracePatches({room, {0.0, 0.0}});
  const FieldRefinement refinement(field, scan);
  const MatchEvidence here = refinement.evidence({});
  EXPECT_EQ(here.points, room.size());
  EXPECT_GT(here.partners, 98 * room.size() / 100);
  EXPECT_LT(std::sqrt(here.squared_residuals / static_cast<double>(here.partners)), 3e-3)
      << "of corners";
  EXPECT_LT(refinement.evidence({0.3, 0.3, 0.2}).partners, here.partners / 2);
}

}  // namespace
}  // namespace omega_slam::matching

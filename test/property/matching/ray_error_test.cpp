#include "omega_slam/matching/ray_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "omega_slam/geometry/angle.h"
#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::kPi;
using geometry::Pose2;

View seenFrom(const Pose2& T_room_laser, double noise, std::mt19937_64& random) {
  return {test::measurePoints(test::furnishedRoom(), T_room_laser, 360, noise, random)};
}

using Ranges = std::vector<std::optional<double>>;

/// What a laser at the origin sees of a scan in each direction, by looking at every pair of
/// neighbours with exact angles.
/// @param measured the scan where it was measured, for who is whose neighbour
/// @param first_direction [rad]
Ranges rangesOf(const Points& points, const View& measured, double first_direction) {
  std::vector<double> angles;
  std::vector<bool> joined{false};
  for (std::size_t i = 0; i < points.size(); ++i) {
    angles.push_back(std::atan2(points[i].y(), points[i].x()));
    joined.push_back(i + 1 < points.size() &&
                     (points[i + 1] - points[i]).norm() <=
                         0.05 + 0.1 * (measured.points[i + 1] - measured.origin).norm());
  }
  Ranges ranges;
  for (int k = 0; k < kRayDirections; ++k) {
    const double direction = first_direction + 2.0 * kPi * k / kRayDirections;
    std::optional<double> nearest;
    const auto see = [&](double range) { nearest = std::min(nearest.value_or(range), range); };
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double angle = geometry::angleDifference(angles[i], direction);
      if (!joined[i] && !joined[i + 1] && std::abs(angle) < kPi / kRayDirections) {
        see(points[i].norm());
      }
      if (!joined[i]) {
        continue;
      }
      const double last = geometry::angleDifference(angles[i - 1], direction);
      if (std::abs(angle - last) > 0.25 * kPi || (angle > 0.0) == (last > 0.0)) {
        continue;  // to the side of the direction, behind, or too wide
      }
      const double share = last / (last - angle);
      see((1.0 - share) * points[i - 1].norm() + share * points[i].norm());
    }
    ranges.push_back(nearest);
  }
  return ranges;
}

double countRays(const Ranges& ranges) {
  return static_cast<double>(
      std::count_if(ranges.begin(), ranges.end(), [](const auto& range) { return !!range; }));
}

/// @param required how many rays must be compared
double squaredErrorOf(const Ranges& a, const Ranges& b, double required) {
  double sum = 0.0;
  double compared = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] && b[k]) {
      compared += 1.0;
      sum += std::min(std::pow(*a[k] - *b[k], 2), 1.0);
    }
  }
  const double all = std::max(compared, required);
  return (sum + all - compared) / all;
}

TEST(RayErrorLaws, AgreesWithBruteForce) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const View reference = seenFrom(test::randomPose(0.8, 3.1, random), 0.01, random);
    const View scan = seenFrom(test::randomPose(0.8, 3.1, random), 0.01, random);
    const RayReference fast(Reference{reference});
    const RayScan prepared(scan);
    const Eigen::Vector2d first = reference.points.front();
    const double first_direction = std::atan2(first.y(), first.x());
    const Ranges slow = rangesOf(reference.points, reference, first_direction);
    const double required =
        0.7 * std::min(countRays(slow), countRays(rangesOf(scan.points, scan, 0.0)));
    for (int i = 0; i < 5; ++i) {
      const Pose2 pose = test::randomPose(2.0, 3.1, random);
      const Ranges seen = rangesOf(transformed(pose, scan).points, scan, first_direction);
      // At the end of a line, a ray more or less may be seen.
      EXPECT_NEAR(fast.squaredError(prepared, pose), squaredErrorOf(slow, seen, required), 3e-3)
          << i;
    }
  }
}

TEST(RayErrorLaws, LeastAtTheTruthAndBoundedEverywhere) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 10; ++i) {
      const Pose2 place = test::randomPose(0.8, 3.1, random);
      const View scan = seenFrom(place, 0.01, random);
      const RayReference same(Reference{scan});
      const RayReference again(Reference{seenFrom(place, 0.01, random)});
      const RayScan prepared(scan);
      EXPECT_LT(same.squaredError(prepared, {}), 1e-12);
      const double at_truth = again.squaredError(prepared, {});
      EXPECT_NEAR(at_truth, 2e-4, 1e-4) << "noise of both scans";
      for (int k = 0; k < 10; ++k) {
        const double elsewhere = again.squaredError(prepared, test::randomPose(5.0, 3.1, random));
        EXPECT_GT(elsewhere, at_truth);
        EXPECT_LE(elsewhere, 1.0);
      }
    }
  }
}

TEST(RayErrorLaws, FrameOfTheReferenceDoesNotMatter) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 10; ++i) {
      const View view = seenFrom(test::randomPose(0.8, 3.1, random), 0.01, random);
      const RayScan scan(seenFrom(test::randomPose(0.8, 3.1, random), 0.01, random));
      const Pose2 pose = test::randomPose(0.5, 3.1, random);
      const Pose2 T_other_reference = test::randomPose(100.0, 3.1, random);
      const double here = RayReference(Reference{view}).squaredError(scan, pose);
      const double there = RayReference(Reference{transformed(T_other_reference, view)})
                               .squaredError(scan, T_other_reference * pose);
      EXPECT_NEAR(here, there, 5e-3) << "a ray or two at the edges";
    }
  }
}

TEST(RayErrorLaws, SymmetricForScansFromOnePlace) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 10; ++i) {
      const Pose2 place = test::randomPose(0.8, 3.1, random);
      const View a = seenFrom(place, 0.01, random);
      const View b = seenFrom(place, 0.01, random);
      const Pose2 T_a_b = test::randomPose(0.0, 3.1, random);
      const double forth = RayReference(Reference{a}).squaredError(RayScan(b), T_a_b);
      const double back = RayReference(Reference{b}).squaredError(RayScan(a), T_a_b.inverse());
      EXPECT_NEAR(forth, back, 5e-3) << "a ray or two at the edges";
    }
  }
}

}  // namespace
}  // namespace omega_slam::matching

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "omega_slam/evaluation/relations.h"
#include "omega_slam/evaluation/resemblance.h"
#include "omega_slam/evaluation/trajectory_error.h"
#include "omega_slam/geometry/angle.h"
#include "support/seeds.h"

namespace omega_slam::evaluation {
namespace {

using geometry::Pose2;
using geometry::Trajectory;

Pose2 randomPose(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-50.0, 50.0);
  std::uniform_real_distribution<double> angle(-geometry::kPi, geometry::kPi);
  return {place(random), place(random), angle(random)};
}

Trajectory randomDrive(std::mt19937_64& random) {
  std::normal_distribution<double> noise;
  Trajectory drive{{100.0, randomPose(random)}};
  for (int k = 1; k < 200; ++k) {
    const Pose2 step{0.1 + 0.02 * noise(random), 0.0, 0.1 * noise(random)};
    drive.push_back({100.0 + 0.2 * k, drive.back().pose * step});
  }
  return drive;
}

Trajectory moved(const Pose2& T_new_old, Trajectory trajectory) {
  for (auto& entry : trajectory) {
    entry.pose = T_new_old * entry.pose;
  }
  return trajectory;
}

TEST(EvaluationProperty, AlignmentFindsTheMotionOfTheFrame) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Trajectory drive = randomDrive(random);
    const Pose2 T_truth_map = randomPose(random);
    const TrajectoryError error = absoluteTrajectoryError(drive, moved(T_truth_map, drive));
    EXPECT_EQ(error.unmatched, 0U);
    EXPECT_LT(error.translation.max, 1e-9);
    EXPECT_LT(error.rotation.max, 1e-9);
    EXPECT_LT(geometry::distance(error.T_truth_map, T_truth_map), 1e-9);
  }
}

TEST(EvaluationProperty, NoOtherAlignmentIsBetter) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0.0, 0.3);
    const Trajectory truth = randomDrive(random);
    Trajectory estimate = moved(randomPose(random), truth);
    for (auto& entry : estimate) {
      entry.pose.x += noise(random);
      entry.pose.y += noise(random);
    }
    const TrajectoryError error = absoluteTrajectoryError(estimate, truth);
    for (int trial = 0; trial < 50; ++trial) {
      const Pose2 nudge{0.02 * noise(random), 0.02 * noise(random), 0.002 * noise(random)};
      double squares = 0.0;
      for (std::size_t k = 0; k < truth.size(); ++k) {
        const Pose2 placed = error.T_truth_map * nudge * estimate[k].pose;
        squares += std::pow(geometry::distance(placed, truth[k].pose), 2);
      }
      EXPECT_GE(squares / static_cast<double>(truth.size()), error.translation.mean_square - 1e-12);
    }
  }
}

TEST(EvaluationProperty, RelationsDoNotDependOnTheFrame) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Trajectory drive = randomDrive(random);
    std::uniform_real_distribution<double> stamp(99.0, 141.0);
    std::vector<graph::Relation> relations;
    for (int k = 0; k < 100; ++k) {
      relations.push_back({stamp(random), stamp(random), randomPose(random)});
    }
    const RelationsScore here = scoreRelations(drive, relations);
    const RelationsScore there = scoreRelations(moved(randomPose(random), drive), relations);
    EXPECT_EQ(here.covered, there.covered);
    EXPECT_LT(here.covered, here.relations);
    EXPECT_GT(here.covered, 0U);
    EXPECT_NEAR(here.translation.mean, there.translation.mean, 1e-9);
    EXPECT_NEAR(here.rotation.mean, there.rotation.mean, 1e-9);
  }
}

TEST(EvaluationProperty, RelationsOfATrajectoryWithItselfHold) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Trajectory drive = randomDrive(random);
    std::uniform_int_distribution<std::size_t> index(0, drive.size() - 1);
    std::vector<graph::Relation> relations;
    for (int k = 0; k < 100; ++k) {
      const auto& from = drive[index(random)];
      const auto& to = drive[index(random)];
      relations.push_back({from.stamp, to.stamp, geometry::relativePose(from.pose, to.pose)});
    }
    const RelationsScore score = scoreRelations(drive, relations, drive);
    EXPECT_EQ(score.covered, 100U);
    EXPECT_LT(score.translation.max, 1e-9);
    EXPECT_LT(score.rotation.max, 1e-9);
  }
}

TEST(EvaluationProperty, SharesLieBetweenZeroAndOneAndSelfIsOne) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> kind(0, 9);
    const auto scribble = [&](int width, int height) {
      grid::OccupancyGrid map = grid::makeGrid({0.1, {-1.0, -1.0}, width, height}, grid::kUnknown);
      for (std::int8_t& cell : map.cells) {
        const int k = kind(random);
        cell = k < 7 ? grid::kFree : (k < 9 ? grid::kOccupied : grid::kUnknown);
      }
      return map;
    };
    grid::OccupancyGrid truth = scribble(40, 30);
    truth.at({10, 10}) = grid::kFree;
    const grid::OccupancyGrid built = scribble(25, 50);
    const Eigen::Vector2d start = truth.geometry.center({10, 10});
    const Resemblance random_pair = compareMaps(built, truth, {randomPose(random), start});
    const Resemblance self = compareMaps(truth, truth, {{}, start});
    for (const Resemblance& r : {random_pair, self}) {
      for (const double share : {r.score(), r.balanced(), r.wallPrecision(), r.wallRecall(),
                                 r.openPrecision(), r.openRecall(), r.coverage()}) {
        EXPECT_GE(share, 0.0);
        EXPECT_LE(share, 1.0);
      }
      EXPECT_LE(r.openRecall(), r.coverage());
    }
    EXPECT_EQ(self.walls_wrong, 0U);
    EXPECT_DOUBLE_EQ(self.wallRecall(), 1.0);
    EXPECT_DOUBLE_EQ(self.openRecall(), 1.0);
  }
}

}  // namespace
}  // namespace omega_slam::evaluation

#include "omega_slam/slam/pipeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "omega_slam/geometry/angle.h"
#include "support/poses.h"
#include "support/room.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;

struct Step {
  Pose2 truth;
  Pose2 odometry;
  sensing::LaserScan scan;
};

/// Twice around in the furnished room, with odometry that turns 4 percent too far.
std::vector<Step> drive() {
  std::mt19937_64 random(4);
  const test::Room room = test::furnishedRoom();
  std::vector<Step> steps;
  Pose2 truth{0.0, -1.2, 0.0};
  Pose2 odometry;
  constexpr int kSteps = 160;
  for (int i = 0; i < kSteps; ++i) {
    Step step{truth, odometry, test::measure(room, truth, 360, 0.01, random)};
    step.scan.stamp = 0.2 * i;
    steps.push_back(step);
    const double turn = 4.0 * geometry::kPi / kSteps;
    truth = truth * Pose2{0.08, 0.0, turn};
    odometry = odometry * Pose2{0.082, 0.0, 1.04 * turn};
  }
  return steps;
}

/// Largest distance of the trajectory from the truth, both from the first pose on.
double worstError(const std::vector<Step>& steps, const geometry::Trajectory& trajectory) {
  double worst = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Pose2 expected = relativePose(steps.front().truth, steps[i].truth);
    worst = std::max(worst, test::gapBetween(expected, trajectory[i].pose).translation);
  }
  return worst;
}

Pipeline run(const std::vector<Step>& steps) {
  Pipeline pipeline;
  for (const Step& step : steps) {
    pipeline.process(step.scan, {}, step.odometry);
  }
  pipeline.finish();
  return pipeline;
}

TEST(Pipeline, ComesHomeWhereOdometryDoesNot) {
  const auto steps = drive();
  const Pipeline pipeline = run(steps);
  const auto trajectory = pipeline.trajectory();
  ASSERT_EQ(trajectory.size(), steps.size());
  geometry::Trajectory odometry;
  for (const Step& step : steps) {
    odometry.push_back({step.scan.stamp, step.odometry});
  }
  EXPECT_GT(worstError(steps, odometry), 0.3);
  EXPECT_LT(worstError(steps, trajectory), 0.06);
}

TEST(Pipeline, FindsTheSecondRoundsLoops) {
  const Pipeline pipeline = run(drive());
  int loops = 0;
  for (const auto& constraint : pipeline.graph().constraints) {
    loops += constraint.kind == graph::ConstraintKind::kLoop ? 1 : 0;
  }
  EXPECT_GE(loops, 1);
}

TEST(Pipeline, SameInputSameOutput) {
  const auto steps = drive();
  const auto first = run(steps).trajectory();
  const auto second = run(steps).trajectory();
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].pose.x, second[i].pose.x);
    EXPECT_EQ(first[i].pose.theta, second[i].pose.theta);
  }
}

TEST(Pipeline, DrawsTheRoom) {
  const Pipeline pipeline = run(drive());
  const auto map = pipeline.map({});
  const auto valueAt = [&](const Eigen::Vector2d& p_map) {
    const auto cell = map.geometry.cellAt(p_map);
    return map.geometry.contains(cell) ? map.at(cell) : grid::kUnknown;
  };
  EXPECT_EQ(valueAt({0.0, 0.0}), grid::kFree);
  EXPECT_EQ(valueAt({0.0, 9.0}), grid::kUnknown);
  int walls = 0;
  for (double x = -3.0; x < 3.0; x += 0.05) {  // the wall at y = -3 lies 1.8 m beside the start
    for (const double off : {-0.05, 0.0, 0.05}) {
      walls += valueAt({x, -1.8 + off}) == grid::kOccupied ? 1 : 0;
    }
  }
  EXPECT_GT(walls, 60);
}

TEST(Pipeline, EveryScanHasAPoseWhateverItSays) {
  auto steps = drive();
  steps.resize(30);
  for (std::size_t i = 5; i < 10; ++i) {
    steps[i].scan.ranges.clear();
  }
  steps[12].scan.ranges.assign(360, std::numeric_limits<float>::quiet_NaN());
  steps[14].scan.ranges.resize(17);
  Pipeline pipeline;
  int rejected = 0;
  for (const Step& step : steps) {
    rejected += pipeline.process(step.scan, {}, step.odometry).rejection.empty() ? 0 : 1;
  }
  EXPECT_EQ(rejected, 6);
  EXPECT_EQ(pipeline.trajectory().size(), steps.size());
  EXPECT_LT(worstError(steps, pipeline.trajectory()), 0.1);
}

TEST(Pipeline, OdometryThatIsNotFiniteIsRefused) {
  Pipeline pipeline;
  auto steps = drive();
  EXPECT_EQ(pipeline.process(steps[0].scan, {}, {std::nan(""), 0.0, 0.0}).rejection,
            "odometry is not finite");
  EXPECT_TRUE(pipeline.trajectory().empty());
  EXPECT_EQ(pipeline.finish().status, graph::SolveStatus::kConverged);
  EXPECT_EQ(pipeline.map({}).geometry.size(), 0U);
}

}  // namespace
}  // namespace omega_slam::slam

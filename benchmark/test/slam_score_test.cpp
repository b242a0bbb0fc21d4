#include "slam/slam_score.h"

#include <gtest/gtest.h>

#include <cmath>

namespace omega_slam::experiments {
namespace {

using geometry::Pose2;

constexpr double kStep = 0.5;  // [m] and [s] between keyframes

slam::KeyframePtr keyframeAt(graph::NodeId id) {
  slam::Keyframe keyframe;
  keyframe.id = id;
  keyframe.sweep.stamp = static_cast<double>(id) * kStep;
  return std::make_shared<const slam::Keyframe>(keyframe);
}

/// Along the x axis; estimated without error, but for the scale of the estimate.
struct StraightRun {
  explicit StraightRun(double scale = 1.0) {
    for (graph::NodeId k = 0; k < 20; ++k) {
      const double stamp = static_cast<double>(k) * kStep;
      recording.truth.push_back({stamp, {stamp, 0.0, 0.0}});
      io::ScanRecord record;
      record.scan.stamp = stamp;
      recording.records.push_back(record);
      run.trajectory.push_back({stamp, {scale * stamp, 0.0, 0.0}});
      run.graph.poses.push_back({scale * stamp, 0.0, 0.0});
      run.keyframes.push_back(keyframeAt(k));
      run.seconds.push_back(0.0);
      if (k > 0) {
        addConstraint(k - 1, k, {scale * kStep, 0.0, 0.0}, graph::ConstraintKind::kMatch);
      }
    }
  }

  void addConstraint(graph::NodeId from, graph::NodeId to, const Pose2& T_from_to,
                     graph::ConstraintKind kind) {
    graph::Constraint constraint{from, to, T_from_to};
    constraint.information = Eigen::Vector3d(1e4, 1e4, 1e4).asDiagonal();
    constraint.kind = kind;
    run.graph.constraints.push_back(constraint);
    run.weights.push_back(1.0);
  }

  Recording recording;
  SlamRun run;
};

TEST(SlamScore, OfAPerfectDriveIsZero) {
  StraightRun straight;
  straight.addConstraint(0, 10, {5.0, 0.0, 0.0}, graph::ConstraintKind::kLoop);
  const SlamScore score = scoreRun(straight.recording, straight.run);
  EXPECT_NEAR(score.error, 0.0, 1e-9);
  EXPECT_EQ(score.covered, 1.0);
  EXPECT_EQ(score.loops, 1U);
  EXPECT_EQ(score.violated, 0U);
  EXPECT_EQ(score.false_loops, 0.0);
  EXPECT_GT(score.odometry_error, 1.0) << "which says that the robot stands";
}

TEST(SlamScore, CountsLoopsThatTheSolutionViolates) {
  StraightRun straight;
  straight.addConstraint(0, 10, {5.19, 0.0, 0.0}, graph::ConstraintKind::kLoop);
  straight.addConstraint(0, 11, {5.5, 0.21, 0.0}, graph::ConstraintKind::kLoop);
  straight.addConstraint(0, 12, {6.0, 0.0, 0.02}, graph::ConstraintKind::kLoop);
  straight.run.withdrawn_loops = {{0, 13, {0.0, 0.0, 0.0}}};
  const SlamScore score = scoreRun(straight.recording, straight.run);
  EXPECT_EQ(score.loops, 4U);
  EXPECT_EQ(score.violated, 3U);
  EXPECT_EQ(score.withdrawn, 1U);
}

TEST(SlamScore, ALoopIsFalseByTheTruthAndNotByWhatItAllows) {
  StraightRun straight;
  straight.addConstraint(0, 10, {5.3, 0.0, 0.0}, graph::ConstraintKind::kLoop);
  straight.addConstraint(0, 11, {5.8, 0.0, 0.0}, graph::ConstraintKind::kLoop);
  straight.run.graph.constraints.back().information(0, 0) = 10.0;  // along a corridor
  straight.addConstraint(0, 12, {6.5, 0.0, 0.0}, graph::ConstraintKind::kLoop);
  straight.run.weights.back() = 0.0;
  EXPECT_EQ(scoreRun(straight.recording, straight.run).false_loops, 1.0);
}

TEST(SlamScore, WithoutTruthThereIsNone) {
  StraightRun straight;
  straight.recording.truth.clear();
  EXPECT_TRUE(std::isnan(scoreRun(straight.recording, straight.run).error));
}

TEST(Honesty, SaysHowErrorsCompareWithCovariances) {
  // Each step is 1 % too long, 5 mm, and claims 1 cm: after n steps n * 5 mm beside sqrt(n) * 1 cm.
  const StraightRun straight(1.01);
  const Honesty honesty = judgeCovariances(straight.recording, straight.run);
  EXPECT_NEAR(honesty.worst_along, 19 * 0.005, 1e-9);
  EXPECT_NEAR(honesty.deviation_there, std::sqrt(19.0) * 0.01, 1e-6);
  EXPECT_EQ(honesty.within, 1.0);
  double expected = 0.0;
  for (int n = 1; n <= 19; ++n) {
    expected += 0.25 * n / 3.0 / 19.0;
  }
  EXPECT_NEAR(honesty.squared_length, expected, 1e-6);
}

}  // namespace
}  // namespace omega_slam::experiments

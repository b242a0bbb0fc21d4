#include "omega_slam/slam/front_end.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "omega_slam/sensing/scan_intake.h"
#include "support/poses.h"
#include "support/room.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;
using graph::ConstraintKind;

sensing::Sweep sweepAt(const Pose2& T_room_base, double stamp,
                       const test::Room& room = test::furnishedRoom()) {
  std::mt19937_64 random(1);
  auto scan = test::measure(room, T_room_base, 360, 0.005, random);
  scan.stamp = stamp;
  return *sensing::ScanIntake({}).process(scan, {}).sweep;
}

motion::Prediction predictionAt(const Pose2& T_odom_base, double stamp) {
  motion::Prediction prediction{stamp, T_odom_base, {}};
  prediction.covariance = Eigen::Vector3d(1e-3, 1e-3, 1e-3).asDiagonal();
  return prediction;
}

TEST(FrontEnd, FirstSweepIsKeyframeZeroWithoutConstraints) {
  FrontEnd front_end;
  const auto result = front_end.process(sweepAt({}, 0.0), predictionAt({5.0, 1.0, 2.0}, 0.0));
  ASSERT_TRUE(result.keyframe);
  EXPECT_EQ(result.keyframe->id, 0U);
  EXPECT_EQ(result.keyframe->T_odom_base.x, 5.0);
  EXPECT_TRUE(result.constraints.empty());
  EXPECT_FALSE(result.match);
}

TEST(FrontEnd, KeepsAKeyframeAfterTranslationRotationOrTime) {
  const auto isKept = [](const Pose2& motion, double seconds) {
    FrontEnd front_end;
    (void)front_end.process(sweepAt({}, 0.0), predictionAt({}, 0.0));
    return front_end.process(sweepAt(motion, seconds), predictionAt(motion, seconds)).keyframe !=
           nullptr;
  };
  const FrontEndConfig defaults;
  EXPECT_FALSE(isKept({0.9 * defaults.keyframe_translation, 0.0, 0.0}, 0.1));
  EXPECT_TRUE(isKept({1.1 * defaults.keyframe_translation, 0.0, 0.0}, 0.1));
  EXPECT_TRUE(isKept({0.0, -1.1 * defaults.keyframe_translation, 0.0}, 0.1));
  EXPECT_FALSE(isKept({0.0, 0.0, 0.9 * defaults.keyframe_rotation}, 0.1));
  EXPECT_TRUE(isKept({0.0, 0.0, -1.1 * defaults.keyframe_rotation}, 0.1));
  EXPECT_FALSE(isKept({}, 0.9 * defaults.keyframe_time));
  EXPECT_TRUE(isKept({}, 1.1 * defaults.keyframe_time));
}

TEST(FrontEnd, TheMatchMendsTheOdometry) {
  FrontEnd front_end;
  (void)front_end.process(sweepAt({}, 0.0), predictionAt({}, 0.0));
  const Pose2 truth{0.45, 0.05, 0.1};
  const Pose2 odometry{0.5, 0.0, 0.16};
  const auto result = front_end.process(sweepAt(truth, 1.0), predictionAt(odometry, 1.0));
  ASSERT_TRUE(result.match_trusted);
  ASSERT_EQ(result.constraints.size(), 3U) << "odometry, what was tracked, and scan to scan";
  EXPECT_EQ(result.constraints[0].kind, ConstraintKind::kOdometry);
  EXPECT_EQ(test::gapBetween(result.constraints[0].T_from_to, odometry).translation, 0.0);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_EQ(result.constraints[i].kind, ConstraintKind::kMatch);
    EXPECT_LT(test::gapBetween(result.constraints[i].T_from_to, truth).translation, 0.03);
    EXPECT_LT(test::gapBetween(result.constraints[i].T_from_to, truth).rotation, 0.02);
  }
  for (const auto& constraint : result.constraints) {
    EXPECT_EQ(graph::faultOf(constraint, 2), "");
  }
}

TEST(FrontEnd, AKeyframeIsTiedToTheTwoBeforeIt) {
  FrontEnd front_end;
  FrontEndResult result;
  for (int i = 0; i < 5; ++i) {
    const Pose2 pose{-1.0 + 0.45 * i, -1.2, 0.0};
    result = front_end.process(sweepAt(pose, i), predictionAt(pose, i));
    ASSERT_TRUE(result.keyframe);
  }
  std::set<graph::NodeId> tied_to;
  for (const auto& constraint : result.constraints) {
    EXPECT_EQ(constraint.to, 4U);
    tied_to.insert(constraint.from);
  }
  EXPECT_EQ(tied_to, (std::set<graph::NodeId>{2, 3}));
}

TEST(FrontEnd, AWrongTurnOfTheOdometryIsFoundThoughItLooksIntoTheUnknown) {
  test::Room ahead;  // and nothing behind
  ahead.walls = {{{2.0, -1.5}, {2.2, 0.4}}, {{2.2, 0.4}, {3.0, 0.9}}, {{1.2, -1.6}, {2.0, -1.5}}};
  FrontEnd front_end;
  (void)front_end.process(sweepAt({}, 0.0, ahead), predictionAt({}, 0.0));
  const auto result =
      front_end.process(sweepAt({}, 0.2, ahead), predictionAt({0.0, 0.0, 2.5}, 0.2));
  EXPECT_TRUE(result.match_trusted);
  EXPECT_LT(std::abs(result.T_keyframe_base.theta), 0.05);
}

TEST(FrontEnd, BelowTheThresholdTheOdometryStandsAlone) {
  FrontEnd front_end;
  (void)front_end.process(sweepAt({}, 0.0), predictionAt({}, 0.0));
  sensing::Sweep blind = sweepAt({0.5, 0.0, 0.0}, 1.0);
  for (auto& beam : blind.beams) {
    beam.kind = sensing::BeamKind::kNoReturn;
  }
  const auto result = front_end.process(blind, predictionAt({0.5, 0.0, 0.0}, 1.0));
  ASSERT_TRUE(result.keyframe);
  EXPECT_FALSE(result.match_trusted);
  ASSERT_EQ(result.constraints.size(), 1U);
  EXPECT_EQ(result.constraints[0].kind, ConstraintKind::kOdometry);
}

TEST(FrontEnd, OdometryConstraintStandsInTheFrameOfItsStart) {
  FrontEnd front_end;
  const Pose2 start{3.0, 4.0, geometry::Pose2{}.theta + 1.5707963267948966};
  (void)front_end.process(sweepAt({}, 0.0), predictionAt(start, 0.0));
  motion::Prediction prediction = predictionAt(start * Pose2{0.5, 0.0, 0.0}, 1.0);
  prediction.covariance = Eigen::Vector3d(0.0, 0.01, 0.0).asDiagonal();  // along odom's y
  const auto result = front_end.process(sweepAt({0.5, 0.0, 0.0}, 1.0), prediction);
  const Eigen::Matrix3d& information = result.constraints[0].information;
  EXPECT_LT(information(0, 0), 0.1 * information(1, 1)) << "the base drives along its x";
}

TEST(FrontEnd, OdometryThatJumpsSaysNothing) {
  FrontEnd front_end;
  (void)front_end.process(sweepAt({}, 0.0), predictionAt({7.0, 1.0, 0.5}, 0.0));
  const Pose2 truth{0.45, 0.0, 0.05};
  const auto result = front_end.process(sweepAt(truth, 0.2), predictionAt({}, 0.2));
  ASSERT_EQ(result.remarks, std::vector<std::string>{"the odometry has jumped"});
  ASSERT_TRUE(result.keyframe);
  EXPECT_LT(test::gapBetween(result.T_keyframe_base, truth).translation, 0.05);
  for (const auto& constraint : result.constraints) {
    EXPECT_LT(test::gapBetween(constraint.T_from_to, truth).translation, 0.05);
  }
}

/// A room without any likeness to the furnished one.
test::Room closet() {
  test::Room room;
  room.addBox({-0.8, -1.3}, {0.9, 1.1});
  room.walls.push_back({{0.4, -1.3}, {0.9, -0.5}});
  return room;
}

/// After ten seconds without a scan: a long way off, and unsure.
motion::Prediction outOfTheDark(const Pose2& T_odom_base, double stamp) {
  motion::Prediction prediction{stamp, T_odom_base, {}};
  prediction.covariance = Eigen::Vector3d(0.2, 0.2, 0.05).asDiagonal();
  return prediction;
}

TEST(FrontEnd, AStretchBeginsWhereTheRobotComesOutOfTheDark) {
  FrontEnd front_end;
  (void)front_end.process(sweepAt({}, 0.0), predictionAt({}, 0.0));
  const Pose2 far{4.0, 1.0, 0.3};
  const auto first = front_end.process(sweepAt({}, 10.0, closet()), outOfTheDark(far, 10.0));
  ASSERT_TRUE(first.keyframe);
  EXPECT_EQ(first.keyframe->stretch, first.keyframe->id);
  EXPECT_FALSE(first.is_lost);
  ASSERT_EQ(first.constraints.size(), 1U);
  EXPECT_EQ(first.constraints[0].kind, ConstraintKind::kOdometry);
  EXPECT_GT(first.constraints[0].information.inverse()(0, 0), 0.1);
  EXPECT_FALSE(front_end.surroundings().isDrawn(0)) << "it would stand beside where it is";

  const Pose2 on{0.45, 0.0, 0.0};
  const auto second = front_end.process(sweepAt(on, 11.0, closet()), predictionAt(far * on, 11.0));
  ASSERT_TRUE(second.keyframe);
  EXPECT_TRUE(second.match_trusted);
  EXPECT_EQ(second.keyframe->stretch, first.keyframe->id);
}

TEST(FrontEnd, NoStretchBeginsWhereTheRobotSeesWhatItKnows) {
  FrontEnd front_end;
  (void)front_end.process(sweepAt({}, 0.0), predictionAt({}, 0.0));
  const Pose2 truth{0.9, 0.3, 0.4};
  const auto result =
      front_end.process(sweepAt(truth, 10.0), outOfTheDark(truth * Pose2{0.2, -0.15, 0.1}, 10.0));
  ASSERT_TRUE(result.keyframe);
  EXPECT_EQ(result.keyframe->stretch, 0U);
  EXPECT_TRUE(result.match_trusted);
  EXPECT_LT(test::gapBetween(result.T_keyframe_base, truth).translation, 0.05);
}

TEST(FrontEnd, ARobotThatIsCarriedAwayIsLostUntilItIsFound) {
  FrontEnd front_end;
  graph::PoseGraph graph;
  double stamp = 0.0;
  const auto see = [&](const Pose2& truth, const Pose2& odometry) {
    const auto result = front_end.process(sweepAt(truth, stamp), predictionAt(odometry, stamp));
    stamp += 0.2;
    if (result.keyframe) {
      graph.poses.push_back(result.belief.pose);
      graph.constraints.insert(graph.constraints.end(), result.constraints.begin(),
                               result.constraints.end());
      front_end.believe(graph);
    }
    return result;
  };
  for (int i = 0; i <= 24; ++i) {  // through the room
    const Pose2 pose{-3.0 + 0.25 * i, -1.2, 0.0};
    EXPECT_FALSE(see(pose, pose).is_lost);
  }
  const std::size_t keyframes = graph.poses.size();
  // Carried back to the other end, and turned; the wheels feel nothing.
  const Pose2 carried = Pose2{-2.0, -2.6, 1.2} * Pose2{3.0, -1.2, 0.0}.inverse();
  bool was_lost = false;
  std::optional<FrontEndResult> found;
  for (int i = 1; i < 80 && !found; ++i) {
    const Pose2 odometry{3.0 + 0.06 * i, -1.2, 0.0};
    const auto result = see(carried * odometry, odometry);
    was_lost = was_lost || result.is_lost;
    EXPECT_FALSE(result.is_lost && result.keyframe);
    if (result.keyframe) {
      found = result;
      const auto gap = test::gapBetween(relativePose(graph.poses.front(), result.belief.pose),
                                        relativePose({-3.0, -1.2, 0.0}, carried * odometry));
      EXPECT_LT(gap.translation, 0.1);
      EXPECT_LT(gap.rotation, 0.05);
    }
  }
  EXPECT_TRUE(was_lost);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->constraints.size(), 1U);
  EXPECT_LT(found->constraints[0].from + 1, keyframes) << "tied to where it is";
  EXPECT_EQ(found->keyframe->stretch, found->keyframe->id);
  EXPECT_FALSE(see(carried * Pose2{3.0, -1.2, 0.0}, {3.0, -1.2, 0.0}).is_lost);
}

TEST(FrontEnd, ResetBeginsAnew) {
  FrontEnd front_end;
  (void)front_end.process(sweepAt({}, 5.0), predictionAt({}, 5.0));
  front_end.reset();
  const auto result = front_end.process(sweepAt({}, 1.0), predictionAt({9.0, 9.0, 1.0}, 1.0));
  ASSERT_TRUE(result.keyframe);
  EXPECT_EQ(result.keyframe->id, 0U);
}

TEST(FrontEnd, ConfigurationIsChecked) {
  FrontEndConfig config;
  config.keyframe_translation = 0.0;
  config.min_confidence = 1.5;
  config.matching.icp.max_iterations = 0;
  const auto sentences = config.validate();
  EXPECT_EQ(sentences.size(), 3U);
  EXPECT_EQ(sentences.back().rfind("icp/max_iterations", 0), 0U);
  EXPECT_THROW(FrontEnd{config}, std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::slam

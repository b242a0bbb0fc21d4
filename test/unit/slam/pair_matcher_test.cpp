#include "omega_slam/slam/pair_matcher.h"

#include <gtest/gtest.h>

#include <memory>

#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/sensing/scan_intake.h"
#include "support/poses.h"
#include "support/room.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;

Keyframe keyframeAt(graph::NodeId id, const test::Room& room, const Pose2& T_room_base) {
  std::mt19937_64 random(id + 1);
  const auto scan = test::measure(room, T_room_base, 360, 0.01, random);
  return {id, T_room_base, *sensing::ScanIntake({}).process(scan, {}).sweep};
}

/// A belief that is off by no more than some centimetres and degrees.
Belief near(const Pose2& pose) {
  return {pose, Eigen::Vector3d(0.05, 0.05, 0.03).cwiseAbs2().asDiagonal()};
}

const Pose2 kFrom{-1.0, -1.2, 0.4};
const Pose2 kMotion{0.4, 0.05, 0.3};

TEST(PairMatcher, TellsTheMotionBetweenTwoScans) {
  const auto room = test::furnishedRoom();
  const auto pair =
      PairMatcher().match(keyframeAt(3, room, kFrom), keyframeAt(5, room, kFrom * kMotion),
                          near(kMotion * Pose2{0.04, -0.03, 0.02}));
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->from, 3U);
  EXPECT_EQ(pair->to, 5U);
  EXPECT_EQ(pair->kind, graph::ConstraintKind::kMatch);
  EXPECT_EQ(graph::faultOf(*pair, 6), "");
  EXPECT_LT(test::gapBetween(pair->T_from_to, kMotion).translation, 0.01);
  EXPECT_LT(test::gapBetween(pair->T_from_to, kMotion).rotation, 0.005);
}

TEST(PairMatcher, SaysNothingWhereItContradictsWhatWasTracked) {
  const auto room = test::furnishedRoom();
  const Belief sure{kMotion * Pose2{0.15, 0.0, 0.0},
                    Eigen::Vector3d(0.01, 0.01, 0.01).cwiseAbs2().asDiagonal()};
  EXPECT_FALSE(
      PairMatcher().match(keyframeAt(0, room, kFrom), keyframeAt(1, room, kFrom * kMotion), sure));
}

TEST(PairMatcher, LeavesTheWayAlongACorridorOpen) {
  const auto corridor = test::endlessCorridor();
  const Pose2 start{0.0, 0.2, 0.0};
  const auto pair = PairMatcher().match(keyframeAt(0, corridor, start),
                                        keyframeAt(1, corridor, start * Pose2{0.4, 0.0, 0.0}),
                                        near({0.43, 0.0, 0.0}));
  ASSERT_TRUE(pair) << "its heading is worth knowing";
  EXPECT_LT(pair->information(0, 0), 10.0) << "along";
  EXPECT_GT(pair->information(1, 1), 1000.0) << "across";
}

TEST(PairMatcher, LeavesScansAloneThatWereTakenFarApart) {
  const auto room = test::furnishedRoom();
  const Pose2 far{1.5, 0.0, 0.0};
  EXPECT_FALSE(
      PairMatcher().match(keyframeAt(0, room, kFrom), keyframeAt(1, room, kFrom * far), near(far)));
}

TEST(PairMatcher, SaysNothingOfAScanThatSawNothing) {
  const auto room = test::furnishedRoom();
  Keyframe blind = keyframeAt(1, room, kFrom * kMotion);
  for (auto& beam : blind.sweep.beams) {
    beam.kind = sensing::BeamKind::kNoReturn;
  }
  EXPECT_FALSE(PairMatcher().match(keyframeAt(0, room, kFrom), blind, near(kMotion)));
}

}  // namespace
}  // namespace omega_slam::slam

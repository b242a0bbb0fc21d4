#include <gtest/gtest.h>

#include <algorithm>

#include "omega_slam/slam/back_end.h"
#include "support/graphs.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;
using graph::Constraint;
using graph::ConstraintKind;
using graph::NodeId;
using test::tie;

constexpr double kWeight = 1e4;  // a centimetre
constexpr int kPatience = 20;    // keyframes, by which a doubt is over

Constraint loop(NodeId from, NodeId to, double y = 0.0) {
  return tie(from, to, {0.5 * (static_cast<double>(to) - from), y, 0.0}, kWeight,
             ConstraintKind::kLoop);
}

Constraint lie(NodeId from, NodeId to) { return loop(from, to, 3.0); }

/// On along a straight line, each keyframe tied to the last and to one ten before.
void driveOn(BackEnd& back_end, int keyframes) {
  for (int i = 0; i < keyframes; ++i) {
    const auto id = static_cast<NodeId>(back_end.graph().poses.size());
    std::vector<Constraint> steps;
    for (const NodeId back : {NodeId{1}, NodeId{10}}) {
      if (back <= id) {
        steps.push_back(
            tie(id - back, id, {0.5 * back, 0.0, 0.0}, kWeight, ConstraintKind::kMatch));
      }
    }
    ASSERT_EQ(back_end.addKeyframe(id, {}, steps), "");
  }
}

class BackEndOfMany : public testing::Test {
 protected:
  BackEndOfMany() { driveOn(back_end_, 2100); }

  [[nodiscard]] std::size_t loops() const {
    const auto& constraints = back_end_.graph().constraints;
    return static_cast<std::size_t>(
        std::count_if(constraints.begin(), constraints.end(),
                      [](const Constraint& c) { return c.kind == ConstraintKind::kLoop; }));
  }
  /// [m] At the last keyframe.
  [[nodiscard]] double error() const {
    const auto& poses = back_end_.graph().poses;
    return distance(poses.back(), {0.5 * static_cast<double>(poses.size() - 1), 0.0, 0.0});
  }

  BackEnd back_end_;
};

TEST_F(BackEndOfMany, ContradictionWaitsAndIsSortedOutWhileTheDriveGoesOn) {
  EXPECT_EQ(back_end_.addConstraints({loop(900, 903), lie(1000, 1003)}), "");
  EXPECT_EQ(back_end_.doubts(), 0U) << "not in this scan";
  EXPECT_EQ(back_end_.withdrawn().size(), 2U) << "who is right is not known";
  EXPECT_LT(error(), 1e-9);
  driveOn(back_end_, 1);
  EXPECT_EQ(back_end_.doubts(), 1U);
  EXPECT_EQ(back_end_.withdrawn().size(), 2U) << "a doubt takes several keyframes";
  driveOn(back_end_, kPatience);
  EXPECT_EQ(loops(), 1U);
  ASSERT_EQ(back_end_.withdrawn().size(), 1U);
  EXPECT_EQ(back_end_.withdrawn()[0].from, 1000U);
  EXPECT_LT(error(), 1e-6);
}

TEST_F(BackEndOfMany, WhatComesDuringADoubtIsKept) {
  EXPECT_EQ(back_end_.addConstraints({lie(1000, 1003)}), "");
  driveOn(back_end_, 2);
  EXPECT_EQ(back_end_.addConstraints({loop(1500, 1503)}), "");
  EXPECT_EQ(back_end_.addConstraints({lie(1600, 1603)}), "");
  driveOn(back_end_, kPatience);
  EXPECT_EQ(back_end_.doubts(), 1U) << "the next not so soon";
  EXPECT_EQ(loops(), 1U);
  EXPECT_EQ(back_end_.withdrawn().size(), 2U);
  EXPECT_EQ(back_end_.graph().constraints.size(), 2 * back_end_.graph().poses.size() - 11 + 1);
  EXPECT_LT(error(), 1e-6);
  back_end_.solve();
  EXPECT_EQ(back_end_.doubts(), 2U) << "in the end it is looked into";
  EXPECT_EQ(back_end_.withdrawn().size(), 2U);
  back_end_.solve();
  EXPECT_EQ(back_end_.doubts(), 2U);
}

TEST_F(BackEndOfMany, DoubtsLieApart) {
  EXPECT_EQ(back_end_.addConstraints({lie(1000, 1003)}), "");
  driveOn(back_end_, kPatience);
  EXPECT_EQ(back_end_.addConstraints({lie(1500, 1503)}), "");
  driveOn(back_end_, kPatience - 5);
  EXPECT_EQ(back_end_.doubts(), 1U) << "a fiftieth of all keyframes is not over";
  driveOn(back_end_, kPatience);
  EXPECT_EQ(back_end_.doubts(), 2U);
}

TEST_F(BackEndOfMany, SolveEndsADoubtThatGoesOn) {
  EXPECT_EQ(back_end_.addConstraints({loop(900, 903), lie(1000, 1003)}), "");
  driveOn(back_end_, 2);
  ASSERT_EQ(back_end_.withdrawn().size(), 2U);
  back_end_.solve();
  EXPECT_EQ(back_end_.withdrawn().size(), 1U);
  EXPECT_EQ(back_end_.doubts(), 1U);
  back_end_.reset();
  EXPECT_TRUE(back_end_.withdrawn().empty());
}

}  // namespace
}  // namespace omega_slam::slam

#include "nodes/common/graph_assembler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "support/seeds.h"

namespace omega_slam {
namespace {

using Verdict = GraphAssembler::Verdict;

constexpr std::uint64_t kRun = 7;

KeyframeArrival keyframe(graph::NodeId id, std::uint64_t run = kRun) {
  return {run, id, ros::Time(id + 1, 0), {static_cast<double>(id), 0.0, 0.0}};
}

ConstraintArrival tie(graph::NodeId from, graph::NodeId to, std::uint64_t run = kRun,
                      graph::ConstraintKind kind = graph::ConstraintKind::kMatch) {
  graph::Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.kind = kind;
  return {run, {constraint}};
}

/// Takes all that is ready. @return the keyframes in their order, and how many constraints came
std::pair<std::vector<graph::NodeId>, std::size_t> drain(GraphAssembler& assembler) {
  std::pair<std::vector<graph::NodeId>, std::size_t> result;
  while (const auto step = assembler.next()) {
    if (step->keyframe) {
      result.first.push_back(step->keyframe->id);
    }
    result.second += step->constraints.size();
  }
  return result;
}

TEST(GraphAssembler, KeyframeZeroNeedsNoConstraint) {
  GraphAssembler assembler;
  EXPECT_EQ(assembler.add(keyframe(0)), Verdict::kNewRun);
  const auto step = assembler.next();
  ASSERT_TRUE(step && step->keyframe);
  EXPECT_EQ(step->keyframe->id, 0U);
  EXPECT_FALSE(assembler.next());
  EXPECT_EQ(assembler.run(), kRun);
}

TEST(GraphAssembler, AKeyframeComesWithTheConstraintsThatTieIt) {
  GraphAssembler assembler;
  assembler.add(keyframe(0));
  assembler.add(keyframe(1));
  EXPECT_EQ(drain(assembler).first.size(), 1U);
  EXPECT_EQ(assembler.waiting(), 1U);
  assembler.add(tie(0, 1));
  const auto step = assembler.next();
  ASSERT_TRUE(step && step->keyframe);
  EXPECT_EQ(step->keyframe->id, 1U);
  EXPECT_EQ(step->constraints.size(), 1U);
  EXPECT_EQ(assembler.stamps(), (std::vector<ros::Time>{ros::Time(1), ros::Time(2)}));
}

TEST(GraphAssembler, ConstraintsBetweenKnownKeyframesGoInAlone) {
  GraphAssembler assembler;
  assembler.add(keyframe(0));
  assembler.add(keyframe(1));
  assembler.add(tie(0, 1));
  drain(assembler);
  assembler.add(tie(1, 0, kRun, graph::ConstraintKind::kLoop));
  const auto step = assembler.next();
  ASSERT_TRUE(step);
  EXPECT_FALSE(step->keyframe);
  EXPECT_EQ(step->constraints.size(), 1U);
}

TEST(GraphAssembler, ALoopNeverComesWithAKeyframe) {
  GraphAssembler assembler;
  const auto loop = tie(0, 1, kRun, graph::ConstraintKind::kLoop);
  assembler.add(keyframe(0));
  assembler.add(keyframe(1));
  assembler.add(loop);
  EXPECT_EQ(drain(assembler).first.size(), 1U) << "a loop alone ties nothing";
  assembler.add(tie(0, 1));
  const auto node = assembler.next();
  ASSERT_TRUE(node && node->keyframe);
  ASSERT_EQ(node->constraints.size(), 1U);
  EXPECT_EQ(node->constraints[0].kind, graph::ConstraintKind::kMatch);
  const auto later = assembler.next();
  ASSERT_TRUE(later && !later->keyframe);
  EXPECT_EQ(later->constraints[0].kind, graph::ConstraintKind::kLoop);
}

TEST(GraphAssembler, AnyOrderOfArrivalGivesTheSameGraph) {
  constexpr graph::NodeId kKeyframes = 20;
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    // Keyframe 0 begins the run; all else in any order, and everything twice.
    std::vector<int> letters;
    for (int i = 0; i < 2 * static_cast<int>(kKeyframes); ++i) {
      letters.insert(letters.end(), {i, i});
    }
    std::mt19937_64 random(seed);
    std::shuffle(letters.begin(), letters.end(), random);
    GraphAssembler assembler;
    std::vector<graph::NodeId> order;
    std::size_t constraints = 0;
    const auto collect = [&] {
      const auto [keyframes, count] = drain(assembler);
      order.insert(order.end(), keyframes.begin(), keyframes.end());
      constraints += count;
    };
    assembler.add(keyframe(0));
    for (const int letter : letters) {
      const auto id = static_cast<graph::NodeId>(letter / 2);
      if (letter % 2 == 0) {
        assembler.add(keyframe(id));
      } else {
        assembler.add(tie(id, id + 1));
      }
      collect();
    }
    std::vector<graph::NodeId> expected(kKeyframes);
    std::iota(expected.begin(), expected.end(), 0U);
    EXPECT_EQ(order, expected);
    EXPECT_EQ(constraints, kKeyframes - 1) << "the last one ties a keyframe that never comes";
  }
}

TEST(GraphAssembler, WhatCameBeforeIsKnown) {
  GraphAssembler assembler;
  assembler.add(keyframe(0));
  EXPECT_EQ(assembler.add(keyframe(0)), Verdict::kKnown);
  drain(assembler);
  EXPECT_EQ(assembler.add(keyframe(0)), Verdict::kKnown);
  EXPECT_EQ(assembler.add(tie(0, 1)), Verdict::kTaken);
  EXPECT_EQ(assembler.add(tie(0, 1)), Verdict::kKnown);
  EXPECT_EQ(assembler.add(tie(0, 1, kRun, graph::ConstraintKind::kOdometry)), Verdict::kTaken);
  ConstraintArrival another = tie(0, 1);
  another.constraints.front().T_from_to.x = 0.001;
  EXPECT_EQ(assembler.add(another), Verdict::kTaken) << "of the same two, by another scan";
  EXPECT_EQ(assembler.add(another), Verdict::kKnown);
}

TEST(GraphAssembler, OnlyKeyframeZeroBeginsANewRun) {
  GraphAssembler assembler;
  EXPECT_EQ(assembler.add(keyframe(3)), Verdict::kOtherRun);
  assembler.add(keyframe(0));
  drain(assembler);
  EXPECT_EQ(assembler.add(keyframe(1, kRun + 1)), Verdict::kOtherRun);
  EXPECT_EQ(assembler.run(), kRun);
  EXPECT_EQ(assembler.add(keyframe(0, kRun + 1)), Verdict::kNewRun);
  EXPECT_EQ(assembler.run(), kRun + 1);
  EXPECT_TRUE(assembler.stamps().empty());
}

TEST(GraphAssembler, ConstraintsOfARunMayComeBeforeIt) {
  GraphAssembler assembler;
  assembler.add(keyframe(0));
  drain(assembler);
  assembler.add(tie(0, 1, kRun + 1));
  EXPECT_FALSE(assembler.next());
  assembler.add(keyframe(0, kRun + 1));
  assembler.add(keyframe(1, kRun + 1));
  EXPECT_EQ(drain(assembler).first.size(), 2U);
}

TEST(GraphAssembler, ConstraintsOfARunThatIsOverNeverEnterTheNext) {
  GraphAssembler assembler;
  assembler.add(keyframe(0));
  assembler.add(keyframe(1));
  assembler.add(keyframe(0, kRun + 1));
  assembler.add(keyframe(1, kRun + 1));
  assembler.add(tie(0, 1));
  EXPECT_EQ(drain(assembler).first.size(), 1U);
}

TEST(GraphAssembler, AResetRefusesTheRunThatItEnded) {
  GraphAssembler assembler;
  assembler.add(keyframe(0));
  drain(assembler);
  assembler.reset();
  EXPECT_EQ(assembler.add(keyframe(0)), Verdict::kOtherRun);
  EXPECT_EQ(assembler.add(tie(0, 1)), Verdict::kOtherRun);
  EXPECT_EQ(assembler.add(keyframe(0, kRun + 1)), Verdict::kNewRun);
}

TEST(GraphAssembler, AResetBeforeAnyRunRefusesNone) {
  GraphAssembler assembler;
  assembler.reset();
  EXPECT_EQ(assembler.add(keyframe(0)), Verdict::kNewRun);
}

TEST(GraphAssembler, WhatIsKeptOfRunsThatNeverBeginIsBounded) {
  GraphAssembler assembler;
  Verdict last = Verdict::kTaken;
  for (graph::NodeId i = 0; i < 5000; ++i) {
    last = assembler.add(tie(i, i + 1, kRun + i));
  }
  EXPECT_EQ(last, Verdict::kOtherRun) << "the oldest was given up, and it is said";
}

}  // namespace
}  // namespace omega_slam

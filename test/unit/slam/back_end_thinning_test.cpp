#include <gtest/gtest.h>

#include <algorithm>

#include "omega_slam/slam/back_end.h"
#include "support/false_loops.h"
#include "support/poses.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;
using graph::Constraint;
using graph::ConstraintKind;
using graph::NodeId;

constexpr NodeId kRound = 20;  // keyframes

BackEndConfig thinning(int keyframes_per_place) {
  BackEndConfig config;
  config.thinning.nodes_per_place = keyframes_per_place;
  return config;
}

/// Keyframe by keyframe, each with its constraints to earlier ones.
void play(const test::GraphProblem& problem, BackEnd& back_end) {
  for (NodeId id = 0; id < problem.truth.size(); ++id) {
    std::vector<Constraint> steps;
    std::vector<Constraint> loops;
    for (const Constraint& constraint : problem.graph.constraints) {
      if (std::max(constraint.from, constraint.to) == id) {
        (constraint.kind == ConstraintKind::kLoop ? loops : steps).push_back(constraint);
      }
    }
    ASSERT_EQ(back_end.addKeyframe(id, {}, steps), "");
    ASSERT_EQ(back_end.addConstraints(loops), "");
  }
  back_end.solve();
}

test::GraphProblem rounds(int count) {
  std::mt19937_64 random(4);
  test::RoundsConfig config;
  config.side = kRound / 4;
  config.rounds = count;
  return test::drivenRounds(config, random);
}

double meanError(const BackEnd& back_end, const std::vector<Pose2>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    sum += distance(back_end.graph().poses[i], truth[i]);
  }
  return sum / static_cast<double>(truth.size());
}

/// Of 20 seeds, at most 76 and 96 keyframes were left of 160 and 320, and the error was 0.037 and
/// 0.042 m in the mean, 0.077 m at most; without thinning 0.032 and 0.034 m, 0.055 m at most.
TEST(BackEndThinning, AGraphGrowsWithTheAreaNotWithTheTime) {
  std::vector<std::size_t> estimated;
  for (const int count : {8, 16}) {
    const auto problem = rounds(count);
    BackEnd back_end(thinning(3));
    play(problem, back_end);
    const graph::PoseGraph& graph = back_end.graph();
    ASSERT_EQ(graph.poses.size(), problem.truth.size()) << "numbers stay";
    estimated.push_back(graph.poses.size() - back_end.retired());
    EXPECT_LT(graph.constraints.size(), 3 * estimated.back());
    EXPECT_LT(meanError(back_end, problem.truth), 0.1);
  }
  EXPECT_LT(estimated[0], 5 * kRound);
  EXPECT_LT(estimated[1], 6 * kRound);
}

/// Neither those that went with a keyframe, nor those that were withdrawn, whatever retires.
TEST(BackEndThinning, NoLoopIsForgotten) {
  std::mt19937_64 random(4);
  auto problem = rounds(6);
  test::addFalseLoops(problem, 8, 1, random);
  const auto all = std::count_if(
      problem.graph.constraints.begin(), problem.graph.constraints.end(),
      [](const Constraint& constraint) { return constraint.kind == ConstraintKind::kLoop; });
  BackEnd back_end(thinning(3));
  play(problem, back_end);
  ASSERT_GT(back_end.retired(), 0U);
  const BeliefAccount account = back_end.beliefs();
  EXPECT_GT(account.folded.size(), 0U);
  EXPECT_EQ(account.withdrawn.size(), 8U);
  const auto& constraints = back_end.graph().constraints;
  const auto left = std::count_if(constraints.begin(), constraints.end(), [](const Constraint& c) {
    return c.kind == ConstraintKind::kLoop;
  });
  EXPECT_EQ(static_cast<std::size_t>(left) + account.folded.size() + account.withdrawn.size(),
            static_cast<std::size_t>(all));
  EXPECT_LT(meanError(back_end, problem.truth), 0.1);
}

TEST(BackEndThinning, ALoopToARetiredKeyframeIsOneToItsAnchor) {
  const auto problem = rounds(6);
  BackEnd back_end(thinning(3));
  play(problem, back_end);
  ASSERT_GT(back_end.retired(), 0U);
  const NodeId retired = back_end.graph().held.at(1);
  const std::size_t count = back_end.graph().constraints.size();
  const auto newest = static_cast<NodeId>(problem.truth.size() - 1);
  Constraint loop;
  loop.from = newest;
  loop.to = retired;
  loop.T_from_to = relativePose(back_end.graph().poses[newest], back_end.graph().poses[retired]);
  loop.kind = ConstraintKind::kLoop;
  EXPECT_EQ(back_end.addConstraints({loop}), "");
  ASSERT_EQ(back_end.graph().constraints.size(), count + 1);
  const Constraint& carried = back_end.graph().constraints.back();
  EXPECT_NE(carried.to, retired);
  EXPECT_LT(test::gapBetween(carried.T_from_to, relativePose(back_end.graph().poses[newest],
                                                             back_end.graph().poses[carried.to]))
                .translation,
            1e-3);
}

TEST(BackEndThinning, WhatHasRetiredGoesWithWhatIsEstimated) {
  const auto problem = rounds(6);
  BackEnd back_end(thinning(3));
  play(problem, back_end);
  const std::vector<Pose2> before = back_end.graph().poses;
  const NodeId retired = back_end.graph().held.back();
  Constraint push;  // far beyond what is known, but no loop: it is believed
  push.from = 0;
  push.to = static_cast<NodeId>(before.size() - 1);
  push.T_from_to = before.back() * Pose2{0.0, 2.0, 0.1};
  push.information *= 1e6;
  push.kind = ConstraintKind::kMatch;
  EXPECT_EQ(back_end.addConstraints({push}), "");
  EXPECT_GT(distance(back_end.graph().poses[retired], before[retired]), 0.01);
}

TEST(BackEndThinning, WithoutItNoneRetiresAndAResetForgetsThoseThatHave) {
  const auto problem = rounds(6);
  BackEnd all(thinning(0));
  play(problem, all);
  EXPECT_EQ(all.retired(), 0U);
  BackEnd back_end(thinning(3));
  play(problem, back_end);
  back_end.reset();
  EXPECT_EQ(back_end.retired(), 0U);
  EXPECT_EQ(back_end.addKeyframe(0, {}, {}), "");
}

}  // namespace
}  // namespace omega_slam::slam

#include "omega_slam/slam/back_end.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "omega_slam/graph/linearization.h"
#include "support/false_loops.h"
#include "support/graphs.h"
#include "support/poses.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;
using graph::Constraint;
using graph::ConstraintKind;
using graph::NodeId;
using test::tie;

/// A square of four sides of 1 m whose last corner the odometry misses by 20 cm.
BackEnd squareWithGap() {
  BackEnd back_end;
  const Pose2 side{1.0, 0.0, 1.5707963267948966};
  EXPECT_EQ(back_end.addKeyframe(0, {}, {}), "");
  for (NodeId i = 1; i < 5; ++i) {
    const Pose2 step = i == 4 ? Pose2{1.2, 0.0, side.theta} : side;
    EXPECT_EQ(back_end.addKeyframe(i, {}, {tie(i - 1, i, step)}), "");
  }
  return back_end;
}

TEST(BackEnd, FirstNodeLiesAtTheOriginOfTheMap) {
  BackEnd back_end;
  EXPECT_EQ(back_end.addKeyframe(0, {3.0, 4.0, 1.0}, {}), "");
  EXPECT_EQ(back_end.graph().poses[0].x, 0.0);
  const Pose2 T_map_base = back_end.mapFromOdometry() * Pose2{3.0, 4.0, 1.0};
  EXPECT_LT(test::gapBetween(T_map_base, {}).translation, 1e-12);
}

TEST(BackEnd, NewNodeLiesWhereItsConstraintsMeet) {
  BackEnd back_end;
  EXPECT_EQ(back_end.addKeyframe(0, {}, {}), "");
  EXPECT_EQ(back_end.addKeyframe(1, {1.0, 0.0, 0.0},
                                 {tie(0, 1, {1.0, 0.0, 0.0}, 1.0),
                                  tie(0, 1, {1.4, 0.0, 0.0}, 3.0, ConstraintKind::kMatch)}),
            "");
  EXPECT_NEAR(back_end.graph().poses[1].x, 1.3, 1e-9);
  EXPECT_NEAR(back_end.mapFromOdometry().x, 0.3, 1e-9);
}

TEST(BackEnd, LoopClosesTheGap) {
  BackEnd back_end = squareWithGap();
  EXPECT_NEAR(std::hypot(back_end.graph().poses[4].x, back_end.graph().poses[4].y), 0.2, 1e-9);
  EXPECT_EQ(back_end.addConstraints({tie(0, 4, {}, 100.0, ConstraintKind::kLoop)}), "");
  EXPECT_EQ(back_end.report().status, graph::SolveStatus::kConverged);
  EXPECT_GT(back_end.report().iterations, 0);
  EXPECT_LT(std::hypot(back_end.graph().poses[4].x, back_end.graph().poses[4].y), 0.05);
  EXPECT_EQ(back_end.graph().poses[0].x, 0.0);
}

TEST(BackEnd, LoopThatAgreesChangesTheSolutionWithoutASolve) {
  BackEnd back_end;
  EXPECT_EQ(back_end.addKeyframe(0, {}, {}), "");
  EXPECT_EQ(back_end.addKeyframe(1, {}, {tie(0, 1, {1.0, 0.0, 0.0})}), "");
  EXPECT_EQ(back_end.addConstraints({tie(0, 1, {1.1, 0.0, 0.0}, 3.0, ConstraintKind::kLoop)}), "");
  EXPECT_EQ(back_end.report().iterations, 0);
  EXPECT_NEAR(back_end.graph().poses[1].x, 1.075, 1e-6);
}

TEST(BackEnd, RefusesWhatWouldCorruptTheGraph) {
  BackEnd back_end;
  EXPECT_EQ(back_end.addKeyframe(1, {}, {}), "keyframe out of turn");
  EXPECT_EQ(back_end.addKeyframe(0, {std::nan(""), 0.0, 0.0}, {}),
            "keyframe's odometry is not finite");
  EXPECT_EQ(back_end.addKeyframe(0, {}, {}), "");
  EXPECT_EQ(back_end.addKeyframe(1, {}, {}), "keyframe without a valid constraint");
  EXPECT_EQ(back_end.addKeyframe(1, {}, {tie(0, 1, {std::nan(""), 0.0, 0.0})}),
            "keyframe without a valid constraint");
  EXPECT_EQ(back_end.graph().poses.size(), 1U);
  EXPECT_EQ(back_end.addKeyframe(1, {}, {tie(0, 1, {1.0, 0.0, 0.0})}), "");
  EXPECT_NE(back_end.addConstraints({tie(0, 7, {}), tie(0, 1, {1.0, 0.0, 0.0})}), "");
  EXPECT_EQ(back_end.graph().constraints.size(), 2U) << "the good one is kept";
}

/// Loops come with the later of their nodes.
BackEnd play(const graph::PoseGraph& graph) {
  BackEnd back_end;
  for (NodeId id = 0; id < graph.poses.size(); ++id) {
    std::vector<Constraint> steps;
    std::vector<Constraint> loops;
    for (const Constraint& constraint : graph.constraints) {
      if (std::max(constraint.from, constraint.to) == id) {
        (constraint.kind == ConstraintKind::kLoop ? loops : steps).push_back(constraint);
      }
    }
    EXPECT_EQ(back_end.addKeyframe(id, {}, steps), "");
    EXPECT_EQ(back_end.addConstraints(loops), "");
  }
  back_end.solve();
  return back_end;
}

double worstGap(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max(worst, distance(a[i], b[i]));
  }
  return worst;
}

TEST(BackEnd, FalseLoopsAreWithdrawnWheneverTheyCome) {
  std::mt19937_64 random(3);
  auto problem = test::drivenRounds({}, random);
  const auto clean = play(problem.graph).graph();
  const std::size_t count = problem.graph.constraints.size();
  test::addFalseLoops(problem, 6, 1, random);
  test::addFalseLoops(problem, 2, 3, random);
  const BackEnd back_end = play(problem.graph);
  EXPECT_EQ(back_end.graph().constraints.size(), count);
  EXPECT_EQ(back_end.withdrawn().size(), 12U);
  const BeliefAccount beliefs = back_end.beliefs();
  EXPECT_EQ(beliefs.weights, back_end.report().weights);
  EXPECT_EQ(beliefs.weights.size(), count);
  EXPECT_EQ(beliefs.withdrawn.size(), 12U);
  EXPECT_LT(worstGap(back_end.graph().poses, clean.poses), 0.02);
}

/// At first, three false loops that agree outvote a true one.
TEST(BackEnd, WithdrawnLoopComesBackWhenMoreIsKnown) {
  std::mt19937_64 random(5);
  const auto problem = test::drivenRounds({}, random);
  const auto first_loop =
      problem.graph.constraints.begin() + static_cast<std::ptrdiff_t>(problem.truth.size()) - 1;
  graph::PoseGraph steps = problem.graph;
  steps.constraints = {problem.graph.constraints.begin(), first_loop};
  BackEnd back_end = play(steps);
  std::vector<Constraint> lies(first_loop + 10, first_loop + 13);
  for (Constraint& lie : lies) {
    lie.T_from_to = Pose2{0.4, 0.0, 0.0} * lie.T_from_to;
  }
  EXPECT_EQ(back_end.addConstraints(lies), "");
  const Constraint& truth = first_loop[11];
  EXPECT_EQ(back_end.addConstraints({truth}), "");
  ASSERT_EQ(back_end.withdrawn().size(), 1U);
  EXPECT_EQ(back_end.withdrawn()[0].T_from_to.x, truth.T_from_to.x);
  std::vector<Constraint> others(first_loop, first_loop + 10);
  others.insert(others.end(), first_loop + 13, problem.graph.constraints.end());
  EXPECT_EQ(back_end.addConstraints(others), "");
  EXPECT_EQ(back_end.withdrawn().size(), 3U);
  EXPECT_EQ(back_end.graph().constraints.size(), problem.truth.size() - 1 + others.size() + 1);
}

/// Where covariances are too small, loops stay that lie far off and that nothing contradicts.
TEST(BackEnd, LoopThatWasLetBeIsNotDoubtedAgain) {
  std::mt19937_64 random(3);
  test::RoundsConfig rounds;
  rounds.confidence = 10.0;
  BackEnd back_end = play(test::drivenRounds(rounds, random).graph);
  const graph::PoseGraph& graph = back_end.graph();
  const double gate = std::pow(BackEndConfig{}.doubt.gate, 2.0);
  const auto far_off =
      std::count_if(graph.constraints.begin(), graph.constraints.end(), [&](const Constraint& c) {
        return c.kind == ConstraintKind::kLoop && graph::chiSquare(graph, c) > gate;
      });
  ASSERT_GT(far_off, 0);
  const std::size_t doubts = back_end.doubts();
  back_end.solve();
  EXPECT_EQ(back_end.doubts(), doubts);
  Constraint lie = graph.constraints.back();  // while one that is new is doubted
  lie.T_from_to = lie.T_from_to * Pose2{3.0, 0.0, 0.0};
  EXPECT_EQ(back_end.addConstraints({lie}), "");
  EXPECT_EQ(back_end.doubts(), doubts + 1);
  EXPECT_TRUE(std::any_of(back_end.withdrawn().begin(), back_end.withdrawn().end(),
                          [&](const Constraint& c) { return c.T_from_to.x == lie.T_from_to.x; }));
}

TEST(BackEnd, ResetForgetsAll) {
  BackEnd back_end = squareWithGap();
  back_end.reset();
  EXPECT_TRUE(back_end.withdrawn().empty());
  EXPECT_TRUE(back_end.graph().poses.empty());
  EXPECT_TRUE(back_end.graph().constraints.empty());
  EXPECT_EQ(back_end.addKeyframe(0, {}, {}), "");
}

TEST(BackEnd, ConfigurationIsChecked) {
  BackEndConfig config;
  config.graph.solver.limits.max_iterations = 0;
  config.graph.batch_nodes = 0;
  EXPECT_EQ(config.validate().size(), 2U);
  EXPECT_THROW(BackEnd{config}, std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::slam

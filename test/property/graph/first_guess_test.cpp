#include "omega_slam/graph/first_guess.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "omega_slam/graph/linearization.h"
#include "support/graphs.h"
#include "support/poses.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

const FirstGuess kGuesses[] = {FirstGuess::kOdometry, FirstGuess::kTree, FirstGuess::kChordal};

/// The poses of a walk, lost but for the first.
PoseGraph forgotten(PoseGraph graph, std::mt19937_64& random) {
  for (std::size_t i = 1; i < graph.poses.size(); ++i) {
    graph.poses[i] = test::randomPose(20.0, 3.0, random);
  }
  return graph;
}

TEST(FirstGuessLaws, WithoutNoiseEachOneIsTheTruth) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const test::GraphProblem problem = test::randomWalk({40, 15, 0.0, 0.0}, random);
    for (const FirstGuess guess : kGuesses) {
      PoseGraph graph = forgotten(problem.graph, random);
      applyGuess(graph, guess);
      for (std::size_t i = 0; i < graph.poses.size(); ++i) {
        EXPECT_LT(test::gapBetween(graph.poses[i], problem.truth[i]).translation, 1e-6);
      }
    }
  }
}

/// Dead reckoning adds up the noise of every turn, the relaxation spreads it over the loops.
TEST(FirstGuessLaws, ChordalIsNearTheMinimumWhereOdometryIsFarFromIt) {
  std::mt19937_64 random(3);
  PoseGraph graph = test::randomWalk({200, 150, 0.1, 0.0}, random).graph;
  PoseGraph by_odometry = graph;
  applyGuess(by_odometry, FirstGuess::kOdometry);
  applyGuess(graph, FirstGuess::kChordal);
  EXPECT_LT(chiSquare(graph), 0.05 * chiSquare(by_odometry));
}

TEST(FirstGuessLaws, HeldNodesStay) {
  std::mt19937_64 random(4);
  PoseGraph graph = test::randomWalk({40, 15, 0.0, 0.0}, random).graph;
  graph.held = {9};
  const geometry::Pose2 held = graph.poses[9];
  for (const FirstGuess guess : kGuesses) {
    PoseGraph moved = graph;
    for (std::size_t i = 0; i < moved.poses.size(); ++i) {
      moved.poses[i] = i == 9 ? held : test::randomPose(20.0, 3.0, random);
    }
    applyGuess(moved, guess);
    EXPECT_LT(test::gapBetween(moved.poses[9], held).translation, 1e-9);
    EXPECT_LT(chiSquare(moved), 1e-6);
  }
}

TEST(FirstGuessLaws, TheBestIsTheTreeWhereAllTurnsAgreeWithIt) {
  std::mt19937_64 random(5);
  PoseGraph graph = test::randomWalk({60, 30, 0.02, 0.5}, random).graph;
  PoseGraph by_tree = graph;
  applyGuess(by_tree, FirstGuess::kTree);
  EXPECT_EQ(applyGuess(graph, FirstGuess::kBest), FirstGuess::kTree);
  EXPECT_EQ(chiSquare(graph), chiSquare(by_tree));
}

TEST(FirstGuessLaws, TheBestIsElseNoWorseThanAnyOfThem) {
  std::mt19937_64 random(5);
  PoseGraph graph = test::randomWalk({60, 30, 0.1, 0.5}, random).graph;
  graph.constraints.back().T_from_to.theta += 2.0;
  PoseGraph best = graph;
  EXPECT_EQ(applyGuess(best, FirstGuess::kBest), FirstGuess::kChordal);
  EXPECT_LE(chiSquare(best), chiSquare(graph));
  for (const FirstGuess guess : kGuesses) {
    PoseGraph other = graph;
    applyGuess(other, guess);
    EXPECT_LE(chiSquare(best), chiSquare(other));
  }
}

TEST(FirstGuessLaws, PartsAndLoneNodesKeepTheirRoots) {
  std::mt19937_64 random(6);
  PoseGraph graph = test::randomWalk({5, 0, 0.0, 0.0}, random).graph;
  graph.poses.push_back({7.0, 8.0, 0.5});
  for (const FirstGuess guess : kGuesses) {
    PoseGraph moved = graph;
    applyGuess(moved, guess);
    EXPECT_EQ(moved.poses[5].vector(), graph.poses[5].vector());
    EXPECT_LT(chiSquare(moved), 1e-9);
  }
}

TEST(FirstGuessLaws, NamesAreReadBack) {
  for (const std::string& name : guessNames()) {
    EXPECT_EQ(guessNames().at(static_cast<std::size_t>(guessFromName(name))), name);
  }
  EXPECT_THROW(static_cast<void>(guessFromName("hunch")), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::graph

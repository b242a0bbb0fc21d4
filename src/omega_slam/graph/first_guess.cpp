#include "omega_slam/graph/first_guess.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "omega_slam/graph/chordal_relaxation.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/topology.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

void guessByTree(PoseGraph& graph, Growth growth) {
  const SpanningForest forest = spanningForest(graph, growth);
  for (const NodeId node : forest.order) {
    graph.poses[node] = poseByTree(graph, forest, node);
  }
  for (const NodeId point : graph.points) {
    graph.poses[point].theta = 0.0;  // not that of the pose that sees it
  }
}

/// Far below half a turn, where the wrong valleys begin. Where a tree is contradicted by more,
/// chordal headings save iterations, too.
constexpr double kContradiction = 0.6;  // rad

bool agreesInTurns(const PoseGraph& graph) {
  return std::all_of(graph.constraints.begin(), graph.constraints.end(),
                     [&](const Constraint& constraint) {
                       return constraint.information(2, 2) <= 0.0 ||
                              std::abs(errorOf(constraint, graph)[2]) < kContradiction;
                     });
}

FirstGuess applyBest(PoseGraph& graph) {
  const std::vector<Pose2> given = graph.poses;
  guessByTree(graph, Growth::kFewest);
  if (agreesInTurns(graph)) {
    return FirstGuess::kTree;
  }
  const std::vector<Pose2> by_tree = std::exchange(graph.poses, given);
  FirstGuess best = FirstGuess::kGiven;
  double least = chiSquare(graph);
  std::vector<Pose2> poses = given;
  for (const FirstGuess guess : {FirstGuess::kOdometry, FirstGuess::kTree, FirstGuess::kChordal}) {
    if (guess == FirstGuess::kTree) {
      graph.poses = by_tree;
    } else {
      graph.poses = given;
      applyGuess(graph, guess);
    }
    const double chi_square = chiSquare(graph);
    if (chi_square < least || !std::isfinite(least)) {
      least = chi_square;
      best = guess;
      poses = graph.poses;
    }
  }
  graph.poses = std::move(poses);
  return best;
}

}  // namespace

std::vector<std::string> guessNames() { return {"given", "odometry", "tree", "chordal", "best"}; }

FirstGuess guessFromName(const std::string& name) {
  const std::vector<std::string> names = guessNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw std::invalid_argument(
        fmt::format("'{}' is not a first guess; known are {}", name, fmt::join(names, ", ")));
  }
  return static_cast<FirstGuess>(found - names.begin());
}

FirstGuess applyGuess(PoseGraph& graph, FirstGuess guess) {
  if (graph.poses.empty() || guess == FirstGuess::kGiven) {
    return FirstGuess::kGiven;
  }
  if (guess == FirstGuess::kBest) {
    return applyBest(graph);
  }
  guessByTree(graph, guess == FirstGuess::kOdometry ? Growth::kChain : Growth::kFewest);
  if (guess == FirstGuess::kChordal) {
    relaxChordally(graph);
  }
  return guess;
}

}  // namespace omega_slam::graph

#pragma once

#include <string>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// Where a solve begins. Gauss-Newton finds the minimum of the valley that it begins in, so bad
/// odometry, taken as the first guess, may lead it to a wrong one.
enum class FirstGuess {
  kGiven,     ///< the graph's poses as they are
  kOdometry,  ///< each node from the one before it
  kTree,      ///< each node along the fewest constraints from a root
  kChordal,   ///< headings by a linear relaxation, then positions (Carlone et al. 2015)
  kBest       ///< kTree if all measured turns agree with it: from there the minimum is quickly
              ///< found; else the one of these whose chi-square is least
};

/// The names of guesses as configurations give them, in the order of the enumeration.
[[nodiscard]] std::vector<std::string> guessNames();

/// @throws std::invalid_argument for a name that is none of them
[[nodiscard]] FirstGuess guessFromName(const std::string& name);

/// Puts the poses of a graph where the guess says. The roots of its spanningForest() stay.
/// @return which guess it was: what kBest chose
FirstGuess applyGuess(PoseGraph& graph, FirstGuess guess);

}  // namespace omega_slam::graph

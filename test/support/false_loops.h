#pragma once

#include <random>

#include "support/graphs.h"

namespace omega_slam::test {

struct RoundsConfig {
  graph::NodeId side{10};  ///< steps of half a metre along each side of a square
  int rounds{3};
  double deviation{0.02};  ///< [m], and half of it [rad], of all measurements
  double confidence{1.0};  ///< factor of the information that measurements claim
};

/// Drives round a square again and again. From the second round on, each node is tied to the one a
/// round before it. Noise is normal, with the information that the constraints state if
/// `confidence` is 1. The first guess is the truth.
[[nodiscard]] GraphProblem drivenRounds(const RoundsConfig& config, std::mt19937_64& random);

/// Adds loops that are false: in each group, neighbouring pairs of nodes claim the same wrong
/// displacement, at random within 5 m and all headings.
/// @return how many
std::size_t addFalseLoops(GraphProblem& problem, int groups, int of_each, std::mt19937_64& random);

}  // namespace omega_slam::test

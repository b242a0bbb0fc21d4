#pragma once

#include <cstddef>
#include <string>

#include "graph/contestants.h"
#include "omega_slam/graph/first_guess.h"
#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::experiments {

/// What the table says of a solver on a graph. Every row is of a process of its own, for the
/// memory.
struct SolveAccount {
  std::string graph;
  std::string guess;
  std::string solver;
  std::size_t poses{0};
  std::size_t constraints{0};
  double initial_chi_square{0.0};
  double chi_square{0.0};  ///< graph::chiSquare at the end; infinite where the solver failed
  double own_cost{0.0};    ///< what the solver itself minimises, at the end, in the same unit
  int iterations{0};
  double milliseconds{0.0};        ///< of the solve alone, the median of some
  double guess_milliseconds{0.0};  ///< of the first guess, where it was made here
  double peak_megabytes{0.0};      ///< of the process
};

/// The table's head, and the account as a line of it.
[[nodiscard]] std::string accountHead();
[[nodiscard]] std::string accountRow(const SolveAccount& account);

struct SolveTask {
  std::string name;  ///< of the graph
  graph::FirstGuess guess{graph::FirstGuess::kBest};
  std::string solver{"ours"};
  int repetitions{5};
};

/// Solves a graph again and again, always from the same guess.
[[nodiscard]] SolveAccount accountFor(const graph::PoseGraph& graph, const SolveTask& task);

/// Sizes and chi-squares of a graph that another program has solved.
/// @param solved at the end; without poses where the solver failed
void score(const graph::PoseGraph& graph, const graph::PoseGraph& solved, SolveAccount& account);

/// Most memory that this process has held [MB], 0 if the system does not say.
[[nodiscard]] double peakMegabytes();

}  // namespace omega_slam::experiments

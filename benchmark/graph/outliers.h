#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::experiments {

/// A graph without false loops, its solution, and how well that is known.
struct CleanGraph {
  std::string name;
  graph::PoseGraph graph;  ///< as it was read
  graph::PoseGraph solution;
  /// [m] root of the mean over all poses of the trace of the position's marginal covariance, node 0
  /// held: how far the solution may be off if the information matrices are right.
  double stated_noise{0.0};
  /// The same, scaled by the root of chi-square over its degrees of freedom: how far it may be off
  /// by what the constraints' errors show. The stricter measure where information is pessimistic.
  double shown_noise{0.0};
};

/// Solves without kernels, from the best first guess.
[[nodiscard]] CleanGraph cleanGraph(std::string name, const graph::PoseGraph& graph);

/// False loops that are added to a graph.
struct FalseLoops {
  std::size_t count{100};
  /// So many neighbouring pairs of nodes each claim the same wrong displacement, without noise.
  std::size_t group{1};
  std::uint64_t seed{1};
};

/// The clean graph, as it was read, with false loops at its end: between two random nodes, claiming
/// a displacement within +-10 m in x and y and any heading, with the mean of the true loops'
/// information.
[[nodiscard]] graph::PoseGraph withFalseLoops(const CleanGraph& clean, const FalseLoops& wanted);

/// How a solver that doubts fared with them.
struct OutlierAccount {
  std::string graph;
  std::size_t poses{0};
  std::string solver;
  FalseLoops wanted;
  std::size_t true_loops{0};
  std::size_t false_kept{0};    ///< believed with a weight of one half or more
  std::size_t true_dropped{0};  ///< true ones with less
  double error{0.0};         ///< [m] root mean square distance of the poses from the clean solution
  double stated_noise{0.0};  ///< [m] of the clean solution
  double shown_noise{0.0};   ///< [m]
  double milliseconds{0.0};  ///< on a processor, of the whole, first guess and all
};

[[nodiscard]] std::string outlierHead();
[[nodiscard]] std::string outlierRow(const OutlierAccount& account);

/// Solves a graph in place. @return weights of all constraints
using DoubtingSolver = std::function<std::vector<double>(graph::PoseGraph&)>;

/// "doubt" is graph::solveWithDoubtfulLoops; "plain" is graph::GraphSolver without a kernel, from
/// the best first guess; "huber", "cauchy", "scaling" and "graduated" are the same with that kernel
/// on loops, three standard deviations wide, from the odometry, which no false loop has touched.
[[nodiscard]] std::vector<std::string> doubtingSolverNames();

/// @throws std::invalid_argument for a name that is none of these
[[nodiscard]] DoubtingSolver doubtingSolver(const std::string& name);

[[nodiscard]] OutlierAccount outlierAccountFor(const CleanGraph& clean, const FalseLoops& wanted,
                                               const std::string& solver);

struct OutlierSweep {
  std::vector<std::size_t> counts{10, 20, 50, 100};
  std::vector<std::size_t> groups{1, 5};
  std::size_t seeds{10};
  std::string solver{"doubt"};
};

/// An account for each combination, after one without false loops.
/// @param report called with each account as soon as it is there
void sweepOutliers(const CleanGraph& clean, const OutlierSweep& sweep,
                   const std::function<void(const OutlierAccount&)>& report);

}  // namespace omega_slam::experiments

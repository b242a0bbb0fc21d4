#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::experiments {

/// Every solver stops when an iteration lowers the cost by less than this share.
inline constexpr double kRelativeGain = 1e-6;
inline constexpr int kMaxIterations = 100;

/// What a solver made of a graph.
struct Solution {
  std::vector<geometry::Pose2> poses;  ///< empty where it failed
  int iterations{0};
  double seconds{0.0};  ///< of the solve, ordering and symbolic factorisation included
};

/// Solves a graph anew from its poses. Whatever a solver wants the graph to be turned into is made
/// before its time begins.
using GraphContestant = std::function<Solution(const graph::PoseGraph&)>;

/// graph::GraphSolver by its defaults, without kernels.
[[nodiscard]] Solution solveOurselves(const graph::PoseGraph& graph);

/// Ceres: Levenberg-Marquardt with CHOLMOD on one thread, analytic Jacobians of the same error.
/// None where Ceres was not there to build with.
[[nodiscard]] std::optional<GraphContestant> ceresContestant();

[[nodiscard]] std::vector<std::string>
graphContestantNames();  ///< "ours", and "ceres" if it is there

/// @throws std::invalid_argument for a name that is none of these
[[nodiscard]] GraphContestant graphContestant(const std::string& name);

}  // namespace omega_slam::experiments

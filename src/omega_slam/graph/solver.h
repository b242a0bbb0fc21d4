#pragma once

#include <string>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

struct SolverConfig {
  int max_iterations{20};
  double relative_gain{1e-6};  ///< stop when an iteration lowers chi-square by less than this share
  double loop_kernel{
      1.0};  ///< Huber threshold of loop constraints, in standard deviations; 0: no kernel

  [[nodiscard]] std::vector<std::string> validate() const;
};

enum class SolveStatus { kConverged, kStopped, kFailed };

struct SolveReport {
  SolveStatus status{SolveStatus::kConverged};
  int iterations{0};
  double initial_chi_square{0.0};  ///< sum of e^T Omega e before
  double chi_square{0.0};          ///< and after
  std::string message;             ///< what went wrong, if it did
};

/// Finds the most likely poses. On failure the graph keeps the poses it had.
SolveReport solve(PoseGraph& graph, const SolverConfig& config = {});

/// Sum of e^T Omega e over all constraints at the graph's poses; e is (translation in the frame of
/// the measurement, wrapped angle), g2o's convention.
[[nodiscard]] double chiSquare(const PoseGraph& graph);

}  // namespace omega_slam::graph

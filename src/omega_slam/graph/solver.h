#pragma once

#include <string>
#include <vector>

#include "omega_slam/graph/descent.h"
#include "omega_slam/graph/graph_system.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/weighing.h"

namespace omega_slam::graph {

enum class SolverMethod {
  kGaussNewton,         ///< full steps, halved where they lead uphill
  kLevenbergMarquardt,  ///< steps damped as much as they must be
  kLinear               ///< the paper's equations: unit information, headings taken as known
};

struct SolverConfig {
  SolverMethod method{SolverMethod::kGaussNewton};
  DescentLimits limits;
  KernelConfig kernels;

  [[nodiscard]] std::vector<std::string> validate() const;
};

enum class SolveStatus {
  kConverged,
  kIterationLimit,  ///< better than before, but still moving
  kFailed           ///< the poses are those from before
};

struct SolveReport {
  SolveStatus status{SolveStatus::kConverged};
  int iterations{0};
  int factorizations{0};
  double initial_chi_square{0.0};   ///< sum of e^T Omega e before, no kernel
  double chi_square{0.0};           ///< and after
  std::vector<double> chi_squares;  ///< after each iteration
  std::vector<double> weights;      ///< [0, 1] of each constraint at the end, by its kernel
  std::string message;              ///< what went wrong, or was made good
};

/// Finds the most likely poses: linearises every constraint at the poses, solves Omega mu = xi for
/// the step, and repeats.
///
/// PoseGraph::held nodes stay where they are. A part of the graph in which none is held is held at
/// its first node, which the report says where there are several parts. What depends on the
/// pattern of Omega alone is kept from call to call. Deterministic. O(work of the factorisation) an
/// iteration: near linear for a robot's path with loops.
class GraphSolver {
 public:
  explicit GraphSolver(const SolverConfig& config = {});  ///< @throws std::invalid_argument

  SolveReport solve(PoseGraph& graph);

 private:
  DescentAccount descend(const DescentTask& task, const DescentLimits& limits) const;
  DescentAccount graduate(PoseGraph& graph, Weighing& weighing);
  DescentAccount solvePaper(PoseGraph& graph);

  SolverConfig config_;
  GraphSystem system_;
};

/// The same for a single call.
SolveReport solve(PoseGraph& graph, const SolverConfig& config = {});

/// Most likely pose of one node, all others held: the optimum of the whole graph where the node is
/// a new leaf.
/// @param constraints those that concern the node; none other is looked at
[[nodiscard]] geometry::Pose2 relaxNode(const PoseGraph& graph, NodeId node,
                                        const std::vector<Constraint>& constraints);

}  // namespace omega_slam::graph

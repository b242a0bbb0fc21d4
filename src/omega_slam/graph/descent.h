#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "omega_slam/graph/graph_system.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/weighing.h"

namespace omega_slam::graph {

/// Adds steps (x, y, theta), three numbers a pose, to poses.
void moveBy(std::vector<geometry::Pose2>& poses, const Eigen::VectorXd& step, double share = 1.0);

/// Cost of a graph at its poses.
struct GraphCost {
  double robust{0.0};      ///< what is minimised: by the kernels
  double chi_square{0.0};  ///< sum of e^T Omega e
};

/// Omega and xi for the step from the graph's poses.
GraphCost fillForm(const PoseGraph& graph, const Weighing& weighing, InformationForm& form);

/// Where a descent ended.
enum class DescentEnd { kConverged, kIterationLimit, kSingular };

struct DescentLimits {
  int max_iterations{20};
  double relative_gain{1e-6};  ///< ends when an iteration lowers the cost by less than this share
};

/// What a descent does with a graph: its poses move downhill in the cost of all constraints.
struct DescentTask {
  PoseGraph& graph;
  GraphSystem& system;  ///< prepared for the graph
  const Weighing& weighing;
};

struct DescentAccount {
  DescentEnd end{DescentEnd::kConverged};
  std::vector<double> chi_squares;  ///< sum of e^T Omega e after each iteration
};

/// Gauss-Newton. A step that leads uphill is halved, again and again. Near the minimum Omega hardly
/// changes, so the last factorisation tells whether another iteration is worth its price.
DescentAccount descendGaussNewton(const DescentTask& task, const DescentLimits& limits);

/// Levenberg-Marquardt: Omega's diagonal grows by a share that shrinks while steps succeed and
/// grows while they do not (Marquardt 1963; Madsen, Nielsen and Tingleff 2004, section 3.2).
DescentAccount descendDamped(const DescentTask& task, const DescentLimits& limits);

}  // namespace omega_slam::graph

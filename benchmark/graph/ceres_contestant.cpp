#include <ceres/ceres.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <array>

#include "experiments/cpu_timer.h"
#include "graph/contestants.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/topology.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

using Block = std::array<double, 3>;  // x, y, theta
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Pose2 toPose(const double* block) { return {block[0], block[1], block[2]}; }

/// S with S^T S = information, which need not be definite.
Eigen::Matrix3d squareRoot(const Eigen::Matrix3d& information) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(information);
  const Eigen::Vector3d roots = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  return roots.asDiagonal() * eigen.eigenvectors().transpose();
}

/// The error of a constraint, whitened.
class ConstraintCost : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  explicit ConstraintCost(const graph::Constraint& constraint)
      : constraint_(constraint), root_(squareRoot(constraint.information)) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const auto at = graph::linearize(constraint_, toPose(parameters[0]), toPose(parameters[1]));
    Eigen::Map<Eigen::Vector3d>{residuals} = root_ * at.error;
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::Map<RowMajor>{jacobians[0]} = root_ * at.J_from;
    }
    if (jacobians != nullptr && jacobians[1] != nullptr) {
      Eigen::Map<RowMajor>{jacobians[1]} = root_ * at.J_to;
    }
    return true;
  }

 private:
  graph::Constraint constraint_;
  Eigen::Matrix3d root_;
};

void build(const graph::PoseGraph& graph, std::vector<Block>& blocks, ceres::Problem& problem) {
  blocks.reserve(graph.poses.size());
  for (const Pose2& pose : graph.poses) {
    blocks.push_back({pose.x, pose.y, pose.theta});
    problem.AddParameterBlock(blocks.back().data(), 3);
  }
  for (const graph::Constraint& constraint : graph.constraints) {
    problem.AddResidualBlock(new ConstraintCost(constraint), nullptr,
                             blocks[constraint.from].data(), blocks[constraint.to].data());
  }
  for (const graph::NodeId root : graph::spanningForest(graph).roots) {
    problem.SetParameterBlockConstant(blocks[root].data());
  }
}

ceres::Solver::Options options() {
  ceres::Solver::Options options;
  options.minimizer_type = ceres::TRUST_REGION;
  options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.num_threads = 1;
  options.max_num_iterations = kMaxIterations;
  options.function_tolerance = kRelativeGain;
  options.gradient_tolerance = 0.0;
  options.parameter_tolerance = 0.0;
  options.logging_type = ceres::SILENT;
  return options;
}

Solution solveByCeres(const graph::PoseGraph& graph) {
  std::vector<Block> blocks;
  ceres::Problem problem;
  build(graph, blocks, problem);
  ceres::Solver::Summary summary;
  const CpuTimer timer;
  ceres::Solve(options(), &problem, &summary);
  Solution solution;
  solution.seconds = timer.seconds();
  solution.iterations = static_cast<int>(summary.iterations.size()) - 1;  // the first is the guess
  if (summary.IsSolutionUsable()) {
    for (const Block& block : blocks) {
      solution.poses.push_back(Pose2::fromVector({block[0], block[1], block[2]}));
    }
  }
  return solution;
}

}  // namespace

std::optional<GraphContestant> ceresContestant() { return solveByCeres; }

}  // namespace omega_slam::experiments

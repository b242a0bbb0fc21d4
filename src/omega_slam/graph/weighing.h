#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/robust_kernel.h"

namespace omega_slam::graph {

/// How much is believed that lies far off, by kind of constraint.
struct KernelConfig {
  RobustKernel odometry{KernelKind::kNone, 1.0};
  RobustKernel match{KernelKind::kNone, 1.0};
  RobustKernel loop{KernelKind::kHuber, 1.0};
  RobustKernel landmark{KernelKind::kNone, 1.0};

  [[nodiscard]] const RobustKernel& of(ConstraintKind kind) const;
  [[nodiscard]] std::vector<std::string> validate() const;
};

/// The cost of each constraint of a graph, and its weight. Kernels that are graduated have weights
/// that a stage fixes; until then they are 1.
class Weighing {
 public:
  Weighing(const KernelConfig& kernels, const PoseGraph& graph);

  /// Whether the constraint costs its square, however far it lies off.
  [[nodiscard]] bool isPlain(std::size_t k) const { return kernels_[k].kind == KernelKind::kNone; }

  [[nodiscard]] RobustCost at(std::size_t k, double squared) const;

  /// Constraints whose kernel is graduated, by index.
  [[nodiscard]] const std::vector<std::size_t>& graduated() const { return graduated_; }
  /// @param weights one for each of graduated()
  void setStage(const std::vector<double>& weights);

 private:
  std::vector<RobustKernel> kernels_;  ///< of each constraint
  std::vector<double> stage_;          ///< weight of each constraint
  std::vector<std::size_t> graduated_;
};

}  // namespace omega_slam::graph

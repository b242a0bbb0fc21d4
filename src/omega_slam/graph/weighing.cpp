#include "omega_slam/graph/weighing.h"

#include "omega_slam/geometry/validation.h"

namespace omega_slam::graph {

const RobustKernel& KernelConfig::of(ConstraintKind kind) const {
  switch (kind) {
    case ConstraintKind::kOdometry:
      return odometry;
    case ConstraintKind::kMatch:
      return match;
    case ConstraintKind::kLandmark:
      return landmark;
    case ConstraintKind::kLoop:
      break;
  }
  return loop;
}

std::vector<std::string> KernelConfig::validate() const {
  geometry::Violations violations;
  violations.include("odometry", odometry.validate());
  violations.include("match", match.validate());
  violations.include("loop", loop.validate());
  violations.include("landmark", landmark.validate());
  return violations.sentences();
}

Weighing::Weighing(const KernelConfig& kernels, const PoseGraph& graph)
    : stage_(graph.constraints.size(), 1.0) {
  kernels_.reserve(graph.constraints.size());
  for (const Constraint& constraint : graph.constraints) {
    if (kernels.of(constraint.kind).kind == KernelKind::kGraduated) {
      graduated_.push_back(kernels_.size());
    }
    kernels_.push_back(kernels.of(constraint.kind));
  }
}

RobustCost Weighing::at(std::size_t k, double squared) const {
  if (kernels_[k].kind == KernelKind::kGraduated) {
    return {stage_[k] * squared, stage_[k]};
  }
  return kernels_[k].at(squared);
}

void Weighing::setStage(const std::vector<double>& weights) {
  for (std::size_t i = 0; i < graduated_.size(); ++i) {
    stage_[graduated_[i]] = weights[i];
  }
}

}  // namespace omega_slam::graph

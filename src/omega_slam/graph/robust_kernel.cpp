#include "omega_slam/graph/robust_kernel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::graph {

std::vector<std::string> kernelNames() {
  return {"none", "huber", "cauchy", "scaling", "graduated"};
}

KernelKind kernelFromName(const std::string& name) {
  const std::vector<std::string> names = kernelNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw std::invalid_argument(
        fmt::format("'{}' is not a kernel; known are {}", name, fmt::join(names, ", ")));
  }
  return static_cast<KernelKind>(found - names.begin());
}

RobustCost RobustKernel::at(double squared) const {
  const double limit = width * width;
  switch (kind) {
    case KernelKind::kNone:
      break;
    case KernelKind::kHuber:
      if (squared > limit) {
        const double error = std::sqrt(squared);
        return {2.0 * width * error - limit, width / error};
      }
      break;
    case KernelKind::kCauchy:
      return {limit * std::log1p(squared / limit), limit / (limit + squared)};
    case KernelKind::kScaling:
      if (squared > limit) {
        const double scale = 2.0 * limit / (limit + squared);
        return {2.0 * scale * squared - limit, scale * scale};
      }
      break;
    case KernelKind::kGraduated:
      if (squared > limit) {
        return {limit, 0.0};
      }
      break;
  }
  return {squared, 1.0};
}

std::vector<std::string> RobustKernel::validate() const {
  geometry::Violations violations;
  violations.requireAbove("width", width, 0.0);
  return violations.sentences();
}

}  // namespace omega_slam::graph

#pragma once

#include <string>
#include <vector>

namespace omega_slam::graph {

/// What a constraint costs that lies far off.
enum class KernelKind {
  kNone,      ///< its square, however far
  kHuber,     ///< linear beyond the width: pulls with a bounded force (Huber 1964)
  kCauchy,    ///< logarithmic: pulls less the farther off it is
  kScaling,   ///< dynamic covariance scaling (Agarwal et al. 2013), whose cost is bounded; the cost
              ///< that belongs to its weights is by MacTavish and Barfoot 2015
  kGraduated  ///< truncated at the width, reached from a convex cost in stages (Yang et al.
              ///< 2020): see graduated_truncation.h
};

/// The names of kernels as configurations give them, in the order of the enumeration.
[[nodiscard]] std::vector<std::string> kernelNames();

/// @throws std::invalid_argument for a name that is none of them
[[nodiscard]] KernelKind kernelFromName(const std::string& name);

/// Cost of a squared error, and the weight by which its quadratic is scaled.
struct RobustCost {
  double cost;
  double weight;
};

struct RobustKernel {
  KernelKind kind{KernelKind::kNone};
  double width{1.0};  ///< [standard deviations] from where on an error counts as far off

  /// @param squared e^T Omega e of the constraint. A kGraduated one is truncated here: weight 0
  /// beyond the width.
  [[nodiscard]] RobustCost at(double squared) const;

  [[nodiscard]] std::vector<std::string> validate() const;
};

}  // namespace omega_slam::graph

#pragma once

#include <cstddef>
#include <vector>

namespace omega_slam::evaluation {

/// What is said of many errors at once. All zero where `count` is zero.
struct ErrorStatistics {
  std::size_t count{0};
  double mean{0.0};
  double deviation{0.0};         ///< standard deviation about the mean (divided by count)
  double mean_square{0.0};       ///< mean of the squares
  double square_deviation{0.0};  ///< standard deviation of the squares
  double max{0.0};

  [[nodiscard]] double rms() const;
};

/// @param errors finite and >= 0, in any unit; the squares are in its square
[[nodiscard]] ErrorStatistics summarize(const std::vector<double>& errors);

}  // namespace omega_slam::evaluation

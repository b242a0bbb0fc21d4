#pragma once

#include <vector>

namespace omega_slam::graph {

/// Graduated non-convexity for the truncated quadratic: Yang, Antonante, Tzoumas and Carlone,
/// "Graduated non-convexity for robust spatial perception", RA-L 2020, section IV (GNC-TLS).
///
/// A cost that is truncated at a width has a local minimum for every choice of outliers. So the
/// problem is solved with a convex cost first and with costs ever closer to the truncated one then.
/// At each stage the weights follow from the residuals in closed form (their equation 14).
class GraduatedTruncation {
 public:
  /// @param width [standard deviations] of the truncation
  /// @param squared squared errors at the solution in which everything has full weight
  GraduatedTruncation(double width, const std::vector<double>& squared);

  /// Nothing lies beyond the width: there is nothing to graduate.
  [[nodiscard]] bool isNeeded() const { return control_ > 0.0; }

  /// Weights in [0, 1] at this stage.
  [[nodiscard]] std::vector<double> weights(const std::vector<double>& squared) const;

  /// On to the next stage.
  void advance();

 private:
  double limit_;         ///< of squared errors
  double control_{0.0};  ///< mu of the paper: 0 is convex, infinity is the truncated quadratic
};

/// Whether all weights are 0 or 1, which is where the stages end.
[[nodiscard]] bool areDecided(const std::vector<double>& weights);

}  // namespace omega_slam::graph

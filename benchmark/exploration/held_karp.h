#pragma once

#include <Eigen/Core>

namespace omega_slam::experiments {

/// At least so long is any closed tour that comes to all places once: the bound of Held and Karp
/// ("The Traveling-Salesman Problem and Minimum Spanning Trees: Part II", 1971), by subgradient
/// steps. In each step places are taxed so that few edges of the least 1-tree meet where too many
/// did; every step's value is a bound, and the greatest counts. Distances need not obey the
/// triangle's inequality.
/// @param distances symmetric, not negative, finite
/// @return 0 for less than two places; for two, there and back
[[nodiscard]] double tourBound(const Eigen::MatrixXd& distances);

}  // namespace omega_slam::experiments

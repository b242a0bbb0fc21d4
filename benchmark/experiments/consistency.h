#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/places.h"
#include "experiments/progress.h"

namespace omega_slam::experiments {

/// Squared Mahalanobis length of a match's error: its square in units of the claimed covariance. Of
/// an honest covariance the mean is 3, for the three degrees of freedom.
[[nodiscard]] double squaredMahalanobis(const matching::MatchResult& result,
                                        const geometry::Pose2& truth);

/// 99.73 % of the errors of an honest covariance lie below: "3 sigma" in three dimensions.
inline constexpr double kThreeSigma = 14.16;

struct ConsistencyOptions {
  std::size_t pairs{1000};
  std::uint32_t seed{1};
  std::vector<std::string> matchers;  ///< all of the factory where empty
};

/// Are claimed covariances true? Pairs of scans taken 0.1 to 0.5 m and up to 0.35 rad apart, the
/// guess off uniformly by up to 0.1 m and 5 degrees.
///
/// Writes `consistency_<arena>.csv`, a row for each matcher: the share of trusted matches whose
/// true error lies inside of the 3-sigma bound, their mean squared Mahalanobis length, and the same
/// of all matches that claim a covariance: those trusted, and those that name an open direction.
void runConsistency(const Arena& arena, const ConsistencyOptions& options,
                    const std::filesystem::path& folder, const Progress& progress);

}  // namespace omega_slam::experiments

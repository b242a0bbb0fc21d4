#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/places.h"
#include "experiments/progress.h"
#include "experiments/scan_trial.h"

namespace omega_slam::experiments {

struct EliminationOptions {
  OdometryNoise noise{OdometryNoise::kTranslation};
  std::size_t scans{100};   ///< places
  std::size_t levels{315};  ///< of noise, up to 1 m or pi, evenly spaced, 0 not among them
  std::uint32_t seed{1};
  std::vector<std::string> matchers;  ///< all of the factory where empty
};

/// The paper's experiment on noise (section 7.3, figures 15 to 20): pairs of scans taken at one
/// place, each with noise of its own, the odometry of the second one displaced; what of the squared
/// error does a match take away?
///
/// Writes `elimination_<arena>_<noise>.csv`, a row for each matcher and level, and
/// `seconds_<arena>_<noise>.csv`, the processor time of each matcher in all its matches, and
/// `places_<arena>_<noise>.csv`, how many places determine a pose. The rows of "information" are
/// those of estimates drawn from the best covariance that the scans allow.
///
/// The squared error is judged on scans without noise from the same place, so that its floor is 0
/// and not the noise of the ranges, which no matcher can take away.
void runElimination(const Arena& arena, const EliminationOptions& options,
                    const std::filesystem::path& folder, const Progress& progress);

}  // namespace omega_slam::experiments

#pragma once

#include <cstdint>
#include <filesystem>

#include "experiments/places.h"

namespace omega_slam::experiments {

/// The paper's figures 9, 10 and 11: the squared error of two scans of one place against how far
/// the second is thought to be displaced. Writes `errors_<arena>.csv` with rows of
/// - "translation": 0 to 4 m in random directions, the mean of `scans` places,
/// - "rotation": 0 to pi to random sides, the same,
/// - "single": -pi to pi at the first place.
void runErrorCurves(const Arena& arena, std::size_t scans, std::uint32_t seed,
                    const std::filesystem::path& folder);

}  // namespace omega_slam::experiments

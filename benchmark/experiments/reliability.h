#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/key_pairs.h"
#include "experiments/progress.h"

namespace omega_slam::experiments {

/// How fast and how reliable matchers are on pairs of key scans, PCL's ICP and NDT beside them.
/// Guesses are off
/// - "near": uniformly by up to 0.1 m and 5 degrees;
/// - "far": by 0.5 m and 30 degrees exactly, to random sides;
/// - "anywhere": uniformly by up to 4 m and pi; own matchers only on every tenth pair.
///
/// Writes `reliability_<source>.csv`, a row for each kind of guess and matcher, with the share of
/// matches within 0.1 m and 2 degrees, and `speed_<source>.csv`, the processor time of a match in
/// microseconds (the least of three runs, the mean over all pairs) and as multiple of PCL's ICP in
/// the "near" matches of this run. Only one thread at work.
///
/// @param source by which the tables are called
/// @param names of matchers, all of the factory where empty
void runReliability(const std::string& source, const KeyPairs& pairs, std::uint32_t seed,
                    const std::vector<std::string>& names, const std::filesystem::path& folder,
                    const Progress& progress);

}  // namespace omega_slam::experiments

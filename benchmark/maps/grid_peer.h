#pragma once

#include <cstdint>
#include <filesystem>

#include "maps/survey.h"

namespace omega_slam::experiments {

/// A thousand scans, taken standing still at true poses along a site's route, drawn in turn by our
/// renderers and by MRPT's occupancy grid: writes `peer_<site>.csv` with the processor time of each
/// and how far its map agrees with our beam map and with the truth. Without MRPT, ours alone.
void runGridPeer(const Site& site, std::uint64_t seed, const std::filesystem::path& folder);

}  // namespace omega_slam::experiments

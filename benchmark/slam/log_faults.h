#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "omega_slam/io/scan_source.h"

namespace omega_slam::experiments {

using Records = std::vector<io::ScanRecord>;

/// Names of what may go wrong with a log, `none` first.
[[nodiscard]] std::vector<std::string> faultNames();

/// The log as it would be with that fault. The same seed gives the same log.
///
///   duplicated_P, missing_P   P % of the scans come twice, or never
///   reordered_P               P % of the scans change places with the next one
///   gap_S                     at a quarter, half and three quarters of the run nothing is heard of
///                             the laser for S seconds, while the robot drives on
///   frozen_laser              there, the laser repeats one scan for ten seconds
///   half_blocked              something 15 cm before the laser hides half of its view
///   person                    somebody walks ahead of the robot, swaying, two minutes of four
///   kidnapped                 at half of the run the robot is carried to where it would have been
///                             20 s later; nothing is seen or felt on the way
///   odometry_reset            at half of the run the odometry begins again at zero
///   odometry_scale            it overstates every way by 5 %
///   turn_scale                it understates every turn by 10 %
///   laser_askew               the laser is said to look 0.05 rad farther to the left than it does
/// @throws std::invalid_argument for another name
[[nodiscard]] Records withFault(const std::string& name, Records records, std::uint64_t seed);

}  // namespace omega_slam::experiments

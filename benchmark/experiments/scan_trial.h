#pragma once

#include <cstdint>
#include <vector>

#include "experiments/places.h"
#include "omega_slam/matching/ray_error.h"

namespace omega_slam::experiments {

/// How the odometry of a second scan errs.
enum class OdometryNoise {
  kTranslation,  ///< in a random direction, by so much [m]
  kRotation      ///< to a random side, by so much [rad]
};

/// Free poses `T_world_base`, the same ones for all experiments with the same seed.
[[nodiscard]] std::vector<geometry::Pose2> drawPlaces(const Arena& arena, std::size_t count,
                                                      std::uint32_t seed);

/// What the odometry says of the pose of a second scan that was taken where the first was.
[[nodiscard]] geometry::Pose2 drawOdometry(OdometryNoise noise, double level,
                                           std::mt19937_64& random);

/// Two scans taken at one place, each with noise of its own. In truth the second lies at the
/// identity, seen from the first.
struct TwoScans {
  matching::View reference;
  matching::View scan;
};

/// The squared error of two scans (the paper's, as RayReference defines it) at any relative pose.
class ScanError {
 public:
  ScanError(const matching::View& reference, const matching::View& scan)
      : reference_({reference}), scan_(scan) {}

  /// [m^2], mean of the rays
  [[nodiscard]] double at(const geometry::Pose2& T_reference_scan) const {
    return reference_.squaredError(scan_, T_reference_scan);
  }

 private:
  matching::RayReference reference_;
  matching::RayScan scan_;
};

[[nodiscard]] TwoScans takeTwoScans(const Arena& arena, const geometry::Pose2& T_world_base,
                                    std::mt19937_64& random);

}  // namespace omega_slam::experiments

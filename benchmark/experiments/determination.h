#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::experiments {

/// How far off a match may be.
struct Tolerance {
  double translation;  ///< [m]
  double rotation;     ///< [rad]
};

/// Length of translation and size of turn between two poses.
struct PoseError {
  double translation;  ///< [m]
  double rotation;     ///< [rad], >= 0

  [[nodiscard]] bool isWithin(const Tolerance& tolerance) const;
};

[[nodiscard]] PoseError errorOf(const geometry::Pose2& estimate, const geometry::Pose2& truth);

/// Standard deviation of a range [m] as a function of the range [m].
using RangeDeviation = std::function<double(double)>;

/// Two scans whose relative pose is known.
struct ScanPair {
  matching::View reference;
  matching::View scan;
  geometry::Pose2 T_reference_scan;
};

/// What two noisy scans can say at most of their relative pose: the Fisher information of
/// `T_reference_scan`, of (x, y, theta) in the reference's axes [1/m^2, 1/(m rad), 1/rad^2].
/// No unbiased estimate has less covariance than its inverse (Cramer and Rao; for laser ranges
/// Censi, "On achievable accuracy for range finder localization", ICRA 2007).
///
/// Every point of the scan that lies on a line of the reference tells its distance to that line,
/// with the deviation of both ranges across the line. Deviations from Censi: points of corners and
/// clutter tell nothing, beams that graze a line are taken to meet it at no less than 12 degrees,
/// and what the scatter of a fitted line's slope would feign to know along it is taken off.
///
/// @param pair without noise, if need be with
[[nodiscard]] Eigen::Matrix3d informationOf(const ScanPair& pair, const RangeDeviation& deviation);

/// Whether two scans determine their relative pose.
enum class Determination {
  kDetermined,
  kTooFewReturns,  ///< less than 30 in one of the scans: matchers refuse it by default
  kOpenDirection   ///< three deviations of the best estimate reach beyond the tolerance
};

[[nodiscard]] Determination determinationOf(const ScanPair& pair, const RangeDeviation& deviation,
                                            const Tolerance& tolerance);

}  // namespace omega_slam::experiments

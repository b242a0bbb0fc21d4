#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::matching {

using Points = std::vector<Eigen::Vector2d>;

/// Why a match is not to be trusted.
enum class MatchFailure { kNone, kTooFewReturns, kNoOverlap, kDegenerate, kNotConverged };

[[nodiscard]] std::string toString(MatchFailure failure);

/// What a matcher found. Everything is finite, whatever went in.
struct MatchResult {
  geometry::Pose2 T_reference_scan;  ///< the guess where the matcher failed before it began
  /// Covariance of (x, y, theta) of `T_reference_scan`, in the reference's frame for the
  /// translation [m^2, m rad, rad^2]. Large in a direction that the scans do not determine.
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Identity()};
  double confidence{
      0.0};             ///< [0, 1]; the caller applies the result only above a threshold of its own
  double overlap{0.0};  ///< [0, 1] share of the scan's points that found a partner
  double residual{0.0};  ///< [m] root mean square distance of the partners
  bool converged{false};
  MatchFailure failure{MatchFailure::kNone};
};

/// Finds the pose of a scan in the frame of a reference.
class ScanMatcher {
 public:
  virtual ~ScanMatcher() = default;

  /// @param reference points of the reference [m], in the reference's frame
  /// @param scan      points of the scan [m], in the scan's frame
  /// @param guess     `T_reference_scan` to begin with
  [[nodiscard]] virtual MatchResult match(const Points& reference, const Points& scan,
                                          const geometry::Pose2& guess) const = 0;
};

}  // namespace omega_slam::matching

#pragma once

#include "omega_slam/matching/ray_error.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// What hill climbing and particle sampling search: the squared error of the rays over the poses of
/// a scan. A few of the scan's points are enough as long as poses are tried in long steps.
class RayLandscape {
 public:
  /// @param reference, scan must outlive the landscape
  /// @param cap [m], see RayReference
  RayLandscape(const Reference& reference, const View& scan, double cap);

  /// [m^2], see RayReference::squaredError; of the whole scan or of part of it
  [[nodiscard]] double error(const geometry::Pose2& T_reference_scan) const;

  /// Says how long the steps from pose to pose [m] are from now on.
  /// @return whether errors now mean more than before: of the whole scan
  bool setStep(double step);

  /// Judges the pose that a search has ended at; kNotConverged if nothing worse is to be said. A
  /// pose that is not finite is refused.
  ///
  /// To the covariance of judgeMatch, which takes the pose for the best one around, is added d d^T
  /// for the step d of a point-to-line match that would begin there. The rays' error is least at
  /// the best pose, but a search that takes one variable at a time may well end beside it.
  [[nodiscard]] MatchResult judge(const geometry::Pose2& T_reference_scan, bool converged,
                                  const MatchConfig& config) const;

 private:
  const Reference& reference_views_;
  const View& scan_view_;
  RayReference reference_;
  RayScan scan_;
  bool whole_{false};  // scan_ has all points
};

}  // namespace omega_slam::matching

#include "omega_slam/matching/ray_landscape.h"

#include "omega_slam/matching/match_quality.h"
#include "omega_slam/matching/point_to_line.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr std::size_t kFewPoints = 120;  // are enough
constexpr double kLongStep = 0.005;      // [m] for steps of so much or more
constexpr double kReach = 0.3;           // [m] of the doubt: partners so far apart are asked
constexpr double kTolerance = 0.1;       // [m] one so far apart counts half
constexpr double kMostDoubt = 1.0;       // [m], [rad]

/// What the surfaces disagree with a pose about: a search may end where the rays' error is least
/// nearby, but not where walls lie on walls.
Eigen::Matrix3d doubtAbout(const Pose2& pose, SurfaceModel& reference, const View& scan,
                           const MatchConfig& config) {
  const auto equations = linearize(reference, scan, pose, {kReach, config.range_noise, kTolerance});
  const Eigen::Vector3d step =
      stepToLeastSquares(equations, pose, pose).cwiseMin(kMostDoubt).cwiseMax(-kMostDoubt);
  return step * step.transpose();
}

}  // namespace

RayLandscape::RayLandscape(const Reference& reference, const View& scan, double cap)
    : reference_views_(reference),
      scan_view_(scan),
      reference_(reference, cap),
      scan_(scan, kFewPoints) {}

double RayLandscape::error(const Pose2& T_reference_scan) const {
  return reference_.squaredError(scan_, T_reference_scan);
}

bool RayLandscape::setStep(double step) {
  if (whole_ || step >= kLongStep) {
    return false;
  }
  scan_ = RayScan(scan_view_);
  whole_ = true;
  return true;
}

MatchResult RayLandscape::judge(const Pose2& T_reference_scan, bool converged,
                                const MatchConfig& config) const {
  if (!T_reference_scan.isFinite()) {  // of a guess near the largest number
    return refusal({}, MatchFailure::kNoOverlap);
  }
  SurfaceModel model(reference_views_);
  MatchResult result = judgeMatch(model, scan_view_, T_reference_scan, config);
  result.covariance += doubtAbout(T_reference_scan, model, scan_view_, config);
  result.converged = converged;
  if (!converged && result.failure == MatchFailure::kNone) {
    result.failure = MatchFailure::kNotConverged;
  }
  return result;
}

}  // namespace omega_slam::matching

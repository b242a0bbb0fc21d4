#include "omega_slam/matching/ray_landscape.h"

#include "omega_slam/matching/match_quality.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr std::size_t kFewPoints = 120;  // are enough
constexpr double kLongStep = 0.005;      // [m] for steps of so much or more

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
  const Points points = allPoints(reference_views_);
  SurfaceModel model(points);
  MatchResult result = judgeMatch(model, scan_view_.points, T_reference_scan, config);
  result.converged = converged;
  if (!converged && result.failure == MatchFailure::kNone) {
    result.failure = MatchFailure::kNotConverged;
  }
  return result;
}

}  // namespace omega_slam::matching

#include "omega_slam/matching/scan_matcher.h"

#include <algorithm>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

bool isFinite(const View& view) {
  return view.origin.allFinite() &&
         std::all_of(view.points.begin(), view.points.end(),
                     [](const Eigen::Vector2d& point) { return point.allFinite(); });
}

}  // namespace

Points allPoints(const Reference& reference) {
  Points points;
  for (const View& view : reference) {
    points.insert(points.end(), view.points.begin(), view.points.end());
  }
  return points;
}

View transformed(const Pose2& T_a_b, const View& view_b) {
  const Eigen::Matrix2d R_a_b = T_a_b.rotation();
  const Eigen::Vector2d t_a_b = T_a_b.translation();
  View view_a;
  view_a.origin = R_a_b * view_b.origin + t_a_b;
  view_a.points.reserve(view_b.points.size());
  for (const Eigen::Vector2d& p_b : view_b.points) {
    view_a.points.push_back(R_a_b * p_b + t_a_b);
  }
  return view_a;
}

std::string toString(MatchFailure failure) {
  switch (failure) {
    case MatchFailure::kNone:
      return "none";
    case MatchFailure::kTooFewReturns:
      return "too few returns";
    case MatchFailure::kTooManyNear:
      return "too many near returns";
    case MatchFailure::kNoOverlap:
      return "no overlap";
    case MatchFailure::kDegenerate:
      return "degenerate";
    case MatchFailure::kNotConverged:
      return "not converged";
  }
  return "unknown";
}

MatchResult refusal(const Pose2& guess, MatchFailure failure) {
  MatchResult result;
  if (guess.isFinite()) {
    result.T_reference_scan = guess;
  }
  result.failure = failure;
  return result;
}

std::vector<std::string> MatchConfig::validate() const {
  geometry::Violations violations;
  violations.requireAtLeast("min_returns", min_returns, 3);
  violations.requireAbove("outlier_distance", outlier_distance, 0.0);
  violations.requireAbove("range_noise", range_noise, 0.0);
  return violations.sentences();
}

std::optional<MatchResult> refuseHopeless(const Reference& reference, const View& scan,
                                          const Pose2& guess, const MatchConfig& config) {
  std::size_t points = 0;
  bool finite = guess.isFinite() && isFinite(scan);
  for (const View& view : reference) {
    points += view.points.size();
    finite = finite && isFinite(view);
  }
  const auto enough = static_cast<std::size_t>(config.min_returns);
  if (finite && scan.points.size() >= enough && points >= enough) {
    return std::nullopt;
  }
  return refusal(guess, MatchFailure::kTooFewReturns);
}

}  // namespace omega_slam::matching

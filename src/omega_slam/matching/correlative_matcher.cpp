#include "omega_slam/matching/correlative_matcher.h"

#include <algorithm>

#include "omega_slam/geometry/validation.h"
#include "omega_slam/matching/correlation_volume.h"
#include "omega_slam/matching/field_refinement.h"
#include "omega_slam/matching/match_quality.h"
#include "omega_slam/matching/ray_sharpening.h"
#include "omega_slam/matching/surface_field.h"
#include "omega_slam/matching/traced_surfaces.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr double kFarthest = 100.0;     // [m] returns farther from their robot are left out
constexpr double kSampleSpacing = 0.4;  // of the reference's surfaces, in outlier distances
constexpr double kPointSpacing = 5.0;   // of the points that are searched with, in its steps
constexpr double kTie = 0.1;            // confidences that differ by less say nothing

/// What a view has within a square around a place, seen from there.
/// @param radius [m] half of the square's side
View viewAround(const View& view, const Eigen::Vector2d& center, double radius) {
  View near;
  // Only where it looks from matters; squares of larger numbers might not be finite.
  near.origin = (view.origin - center).cwiseMax(-4.0 * kFarthest).cwiseMin(4.0 * kFarthest);
  for (const Eigen::Vector2d& point : view.points) {
    if ((point - center).cwiseAbs().maxCoeff() <= radius) {
      near.points.push_back(point - center);
    }
  }
  return near;
}

double farthestOf(const Points& points) {
  double farthest = 0.0;
  for (const Eigen::Vector2d& point : points) {
    farthest = std::max(farthest, point.norm());
  }
  return farthest;
}

Pose2 shifted(const Pose2& pose, const Eigen::Vector2d& by) {
  return {pose.x + by.x(), pose.y + by.y(), pose.theta};
}

/// The returns that a scan is searched for with, evenly in space. Those that stand alone are left
/// out unless there are few others: they may be anything, and where they are far apart on a wall
/// they tie the scan to the spacing of the beams.
/// @param spacing [m]
Points pointsToSearchWith(const std::vector<SurfacePatch>& scan, int min_returns, double spacing) {
  Points all;
  Points joined;
  bool joins_last = false;
  for (const SurfacePatch& patch : scan) {
    all.push_back(patch.hit);
    if (joins_last || patch.joins_next) {
      joined.push_back(patch.hit);
    }
    joins_last = patch.joins_next;
  }
  const bool enough = joined.size() >= static_cast<std::size_t>(min_returns);
  return thinned(enough ? joined : all, spacing);
}

Points placesOf(const std::vector<SurfaceSample>& samples) {
  Points places;
  for (const SurfaceSample& sample : samples) {
    places.push_back(sample.place);
  }
  return places;
}

struct Settings {
  const CorrelativeMatcherConfig& own;
  const MatchConfig& match;
};

/// One match, with all that matters within a few hundred metres of the frame's origin.
class Attempt {
 public:
  Attempt(const Reference& reference, const View& scan, const Pose2& guess,
          const Settings& settings)
      : settings_(settings),
        reference_(reference),
        view_(scan),
        guess_(guess),
        scan_(tracePatches(scan)),
        surfaces_(traceSurfaces(reference, kSampleSpacing * settings.match.outlier_distance)),
        search_(placesOf(surfaces_.samples),
                pointsToSearchWith(scan_, settings.match.min_returns,
                                   kPointSpacing * settings.own.resolution),
                guess,
                {settings.own.window, settings.own.resolution, settings.match.outlier_distance,
                 settings.own.least_score, settings.own.least_rival}) {}

  /// @param count of peaks, at most
  [[nodiscard]] CorrelativeMatch run(std::size_t count) const {
    CorrelativeMatch match;
    match.peaks = search_.peaks(count);
    if (match.peaks.empty()) {
      match.result = refusal(guess_, MatchFailure::kNoOverlap);
      return match;
    }
    const SurfaceField field(surfaces_, settings_.match.outlier_distance);
    const FieldRefinement refinement(field, scan_);
    const Pose2& peak = match.peaks.front().T_reference_scan;
    match.result = finish(refinement, peak, peak);
    if (const auto sharp = sharpenByRays(reference_, view_, match.result, settings_.match)) {
      match.result.T_reference_scan = *sharp;
    } else if (match.result.open_direction) {
      // Nothing but the guess knows better there, unless that would lose the scan.
      const MatchResult held = finish(refinement, match.result.T_reference_scan, guess_);
      match.result = held.confidence + kTie >= match.result.confidence ? held : match.result;
    }
    if (!match.result.converged && match.result.failure == MatchFailure::kNone) {
      match.result.failure = MatchFailure::kNotConverged;
    }
    return match;
  }

 private:
  /// Refines and judges a pose.
  /// @param hold what open directions lead back to
  [[nodiscard]] MatchResult finish(const FieldRefinement& refinement, const Pose2& start,
                                   const Pose2& hold) const {
    const double noise = settings_.match.range_noise;
    const Refinement refined = refinement.refine(start, hold, noise, settings_.own.max_refinements);
    const Pose2& pose = refined.T_reference_scan;
    MatchResult result = judgeEvidence(refinement.evidence(pose), pose, settings_.match);
    result.converged = refined.converged;
    result.covariance =
        widenByVolume(search_, pose, result.covariance, std::max(noise, result.residual));
    nameOpenDirection(result);
    return result;
  }

  Settings settings_;
  const Reference& reference_;
  const View& view_;
  Pose2 guess_;
  std::vector<SurfacePatch> scan_;
  TracedSurfaces surfaces_;
  CorrelativeSearch search_;
};

}  // namespace

std::vector<std::string> CorrelativeMatcherConfig::validate() const {
  geometry::Violations violations;
  violations.requireWithin("window/translation", window.translation, 0.0, 10.0);
  violations.requireWithin("window/rotation", window.rotation, 0.0, 3.15);
  violations.requireWithin("resolution", resolution, 0.002, 1.0);
  violations.requireWithin("least_score", least_score, 0.0, 1.0);
  violations.requireWithin("least_rival", least_rival, 0.0, 1.0);
  violations.requireAtLeast("max_refinements", max_refinements, 0);
  return violations.sentences();
}

double CorrelativeMatch::ambiguity() const {
  return peaks.size() < 2 ? 0.0 : peaks[1].score / peaks[0].score;
}

CorrelativeMatcher::CorrelativeMatcher(const CorrelativeMatcherConfig& config,
                                       const MatchConfig& common)
    : config_(config), common_(common) {
  geometry::throwIfAny(config_.validate());
  geometry::throwIfAny(common_.validate());
}

MatchResult CorrelativeMatcher::match(const Reference& reference, const View& scan,
                                      const Pose2& guess) const {
  return matchWithPeaks(reference, scan, guess, 1).result;
}

CorrelativeMatch CorrelativeMatcher::matchWithPeaks(const Reference& reference, const View& scan,
                                                    const Pose2& guess, std::size_t count) const {
  if (auto refused = refuseHopeless(reference, scan, guess, common_)) {
    return {*refused, {}};
  }
  // Seen from the guess, so that numbers are small wherever the reference's frame may lie.
  const Eigen::Vector2d center = guess.translation();
  const View near_scan = viewAround(scan, Eigen::Vector2d::Zero(), kFarthest);
  const double reach =
      farthestOf(near_scan.points) + 2.0 * config_.window.translation + common_.outlier_distance;
  Reference near_reference;
  for (const View& view : reference) {
    near_reference.push_back(viewAround(view, center, reach));
  }
  CorrelativeMatch match =
      Attempt(near_reference, near_scan, shifted(guess, -center), {config_, common_}).run(count);
  match.result.T_reference_scan = shifted(match.result.T_reference_scan, center);
  for (CorrelativePeak& peak : match.peaks) {
    peak.T_reference_scan = shifted(peak.T_reference_scan, center);
  }
  return match;
}

}  // namespace omega_slam::matching

#include "omega_slam/matching/icp_matcher.h"

// GCC 12 takes PCL's three floats for an array that Eigen reads beyond its end: a false alarm, in a
// header.
#pragma GCC diagnostic ignored "-Warray-bounds"

#include <pcl/console/print.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/transformation_estimation_2D.h>

#include <cmath>
#include <optional>

#include "omega_slam/geometry/validation.h"
#include "omega_slam/matching/match_quality.h"
#include "omega_slam/matching/pcl_conversions.h"
#include "omega_slam/matching/point_to_line.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Icp = pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ>;

/// PCL's step that ends the search [m^2 of squared translation]; well below what a laser resolves.
constexpr double kSmallestStep = 1e-8;
constexpr int kRefinements = 10;
constexpr double kTie = 0.1;  // confidences that differ by less say nothing

struct Alignment {
  Pose2 T_reference_scan;
  bool converged;  // before the iterations ran out
};

/// PCL's ICP, point to point. The wide pass finds the way from a poor guess; the narrow one leaves
/// out what only one scan has seen. None where the scans do not overlap.
std::optional<Alignment> alignPoints(const Points& reference, const Points& scan,
                                     const Pose2& guess, const IcpMatcherConfig& config,
                                     double outlier_distance) {
  Icp icp;
  // Planar: the general estimate may tip a flat cloud out of its plane.
  icp.setTransformationEstimation(Icp::TransformationEstimationPtr(
      new pcl::registration::TransformationEstimation2D<pcl::PointXYZ, pcl::PointXYZ>));
  icp.setInputTarget(toCloud(reference));
  icp.setInputSource(toCloud(scan));
  icp.setMaximumIterations(config.max_iterations);
  icp.setTransformationEpsilon(kSmallestStep);

  Cloud aligned;
  Alignment alignment{guess, false};
  for (const double reach : {config.max_correspondence_distance, outlier_distance}) {
    icp.setMaxCorrespondenceDistance(reach);
    icp.align(aligned, toMatrix(alignment.T_reference_scan));
    const Pose2 found = toPose(icp.getFinalTransformation());
    if (!icp.hasConverged() || !found.isFinite()) {
      return std::nullopt;
    }
    alignment = {
        found,
        icp.getConvergeCriteria()->getConvergenceState() !=
            pcl::registration::DefaultConvergenceCriteria<float>::CONVERGENCE_CRITERIA_ITERATIONS};
  }
  return alignment;
}

}  // namespace

std::vector<std::string> IcpMatcherConfig::validate() const {
  geometry::Violations violations;
  violations.requireAtLeast("max_iterations", max_iterations, 1);
  violations.requireAbove("max_correspondence_distance", max_correspondence_distance, 0.0);
  return violations.sentences();
}

IcpMatcher::IcpMatcher(const IcpMatcherConfig& config, const MatchConfig& common)
    : config_(config), common_(common) {
  geometry::throwIfAny(config_.validate());
  geometry::throwIfAny(common_.validate());
  // PCL prints to stderr when two scans do not overlap; here that is an answer, which the caller
  // gets.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
}

MatchResult IcpMatcher::match(const Reference& reference, const View& scan,
                              const Pose2& guess) const {
  if (auto refused = refuseHopeless(reference, scan, guess, common_)) {
    return *refused;
  }
  const Points points = allPoints(reference);
  const auto aligned = alignPoints(points, scan.points, guess, config_, common_.outlier_distance);
  if (!aligned) {
    return refusal(guess, MatchFailure::kNoOverlap);
  }
  SurfaceModel model(reference);
  const auto finish = [&](const Pose2& start) {
    const Pose2 refined = refinePointToLine(
        model, scan, start, {kRefinements, common_.outlier_distance, common_.range_noise});
    return judgeMatch(model, scan, refined, common_);
  };
  MatchResult result = finish(aligned->T_reference_scan);
  result.converged = aligned->converged;
  // In a corridor the points of the walls pull the scan along it to where most of them overlap,
  // with nothing to hold it; steps from the guess itself leave it there. The guess wins unless the
  // points know better.
  MatchResult from_guess = finish(guess);
  from_guess.converged = true;
  if (from_guess.confidence + kTie >= result.confidence) {
    result = from_guess;
  }
  if (!result.converged && result.failure == MatchFailure::kNone) {
    result.failure = MatchFailure::kNotConverged;
  }
  return result;
}

}  // namespace omega_slam::matching

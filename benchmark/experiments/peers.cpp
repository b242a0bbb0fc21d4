#include "experiments/peers.h"

// GCC 12 takes PCL's three floats for an array that Eigen reads beyond its end, and Eigen's
// singular values for never written: false alarms, in headers.
#pragma GCC diagnostic ignored "-Warray-bounds"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include <pcl/console/print.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/ndt.h>
#include <pcl/registration/transformation_estimation_2D.h>

#include "omega_slam/matching/pcl_conversions.h"

namespace omega_slam::experiments {

using geometry::Pose2;
using matching::MatchFailure;
using matching::MatchResult;

namespace {

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;

constexpr int kIcpIterations = 50;
constexpr double kIcpReach = 0.5;          // [m]
constexpr double kIcpSmallestStep = 1e-8;  // [m^2]
constexpr int kNdtIterations = 35;
constexpr float kNdtCell = 1.0F;           // [m]
constexpr double kNdtStep = 0.05;          // [m]
constexpr double kNdtSmallestStep = 1e-3;  // [m]

/// Runs a registration that is set up but for its clouds.
MatchResult align(pcl::Registration<Point, Point>& registration,
                  const matching::Reference& reference, const matching::View& scan,
                  const Pose2& guess) {
  if (scan.points.empty() || matching::allPoints(reference).empty()) {
    return matching::refusal(guess, MatchFailure::kTooFewReturns);
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  registration.setInputTarget(matching::toCloud(matching::allPoints(reference)));
  registration.setInputSource(matching::toCloud(scan.points));
  Cloud aligned;
  registration.align(aligned, matching::toMatrix(guess));
  const Pose2 found = matching::toPose(registration.getFinalTransformation());
  if (!registration.hasConverged() || !found.isFinite()) {
    return matching::refusal(guess, MatchFailure::kNoOverlap);
  }
  MatchResult result;
  result.T_reference_scan = found;
  result.converged = true;
  result.confidence = 1.0;
  return result;
}

}  // namespace

MatchResult PclIcp::match(const matching::Reference& reference, const matching::View& scan,
                          const Pose2& guess) const {
  pcl::IterativeClosestPoint<Point, Point> icp;
  using InThePlane = pcl::registration::TransformationEstimation2D<Point, Point>;
  icp.setTransformationEstimation(InThePlane::Ptr(new InThePlane));
  icp.setMaximumIterations(kIcpIterations);
  icp.setMaxCorrespondenceDistance(kIcpReach);
  icp.setTransformationEpsilon(kIcpSmallestStep);
  return align(icp, reference, scan, guess);
}

MatchResult PclNdt::match(const matching::Reference& reference, const matching::View& scan,
                          const Pose2& guess) const {
  pcl::NormalDistributionsTransform<Point, Point> ndt;
  ndt.setResolution(kNdtCell);
  ndt.setStepSize(kNdtStep);
  ndt.setMaximumIterations(kNdtIterations);
  ndt.setTransformationEpsilon(kNdtSmallestStep);
  return align(ndt, reference, scan, guess);
}

}  // namespace omega_slam::experiments

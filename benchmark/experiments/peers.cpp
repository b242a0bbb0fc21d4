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

#include <cmath>

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

Cloud::Ptr toCloud(const matching::Points& points) {
  auto cloud = Cloud::Ptr(new Cloud);
  cloud->reserve(points.size());
  for (const Eigen::Vector2d& point : points) {
    cloud->push_back(Point(static_cast<float>(point.x()), static_cast<float>(point.y()), 0.0F));
  }
  return cloud;
}

Eigen::Matrix4f toMatrix(const Pose2& pose) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<2, 2>() = pose.rotation();
  matrix.topRightCorner<2, 1>() = pose.translation();
  return matrix.cast<float>();
}

/// Runs a registration that is set up but for its clouds.
MatchResult align(pcl::Registration<Point, Point>& registration,
                  const matching::Reference& reference, const matching::View& scan,
                  const Pose2& guess) {
  if (scan.points.empty() || matching::allPoints(reference).empty()) {
    return matching::refusal(guess, MatchFailure::kTooFewReturns);
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  registration.setInputTarget(toCloud(matching::allPoints(reference)));
  registration.setInputSource(toCloud(scan.points));
  Cloud aligned;
  registration.align(aligned, toMatrix(guess));
  const Eigen::Matrix4d m = registration.getFinalTransformation().cast<double>();
  const Pose2 found{m(0, 3), m(1, 3), std::atan2(m(1, 0), m(0, 0))};
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

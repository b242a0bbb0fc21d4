#pragma once

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/scan_matcher.h"
#include "omega_slam/matching/surface_model.h"

namespace omega_slam::matching {

/// [m] A direction of (x, y, theta * 1 m) that is known no better than this is open.
inline constexpr double kOpenDeviation = 0.3;

/// A point and what it lies on are both noisy: variance of their distance in units of a range's.
inline constexpr double kDistanceVariance = 2.0;

/// What the points of a scan, laid on a reference, say of the pose that laid them there.
struct MatchEvidence {
  std::size_t points{0};          ///< of the scan
  std::size_t partners{0};        ///< that the reference had for them
  double squared_residuals{0.0};  ///< [m^2] sum over the partners
  /// Information on (x, y, theta) to build on, in units of a range's.
  Eigen::Matrix3d hessian{Eigen::Matrix3d::Zero()};

  /// Adds a point that has a partner.
  /// @param surface of the reference around the partner
  /// @param gap [m] from the partner to the point
  /// @param arm [m] from the scan's origin to the point; both in the reference's axes
  /// @param facing normal of the surface that the point is on; zero where it is not known
  void add(const Surface& surface, const Eigen::Vector2d& gap, const Eigen::Vector2d& arm,
           const Eigen::Vector2d& facing = Eigen::Vector2d::Zero());
  /// The same without what it says of the pose.
  void addDistance(const Surface& surface, const Eigen::Vector2d& gap);

  [[nodiscard]] double overlap() const;   ///< [0, 1]; there must be points
  [[nodiscard]] double residual() const;  ///< [m]; there must be partners
  /// [0, 1] overlap * (1 - (residual / outlier_distance)^2); without partners none.
  [[nodiscard]] double confidence(const MatchConfig& config) const;
};

/// Overlap, residual, confidence and covariance from what the points say: see judgeMatch.
[[nodiscard]] MatchResult judgeEvidence(const MatchEvidence& evidence,
                                        const geometry::Pose2& T_reference_scan,
                                        const MatchConfig& config);

/// Names the direction that the covariance leaves open, if any, and sets `failure` to kDegenerate.
void nameOpenDirection(MatchResult& result);

/// Judges a pose that some matcher has found: overlap, residual, confidence and covariance.
///
/// Each scan point's partner is its nearest reference point; the reference's surface there is the
/// line through that point's neighbours. One that shows the scan its other side is none.
///
/// The covariance is the inverse of the point-to-line Hessian, times sigma^2, after Censi 2007 ("An
/// accurate closed-form estimate of ICP's covariance", ICRA), simplified: the error of every
/// distance is taken as independent, with twice the variance of a range or of the residual,
/// whichever is larger, since both scans are noisy. Only the part of the Hessian to build on
/// counts: see certainInformation. A weak prior keeps the covariance finite along directions that
/// nothing determines, where it is large. Points on one wall err together, so a floor is added that
/// no number of points gets below.
///
/// A direction of (x, y, theta * 1 m) that is known no better than kOpenDeviation is open; of
/// several, the one known least is named.
///
/// Confidence is MatchEvidence::confidence.
///
/// Fills every field of the result but `converged`; sets `failure` to kNoOverlap or kDegenerate,
/// and names the open direction, where that holds.
[[nodiscard]] MatchResult judgeMatch(SurfaceModel& reference, const View& scan,
                                     const geometry::Pose2& T_reference_scan,
                                     const MatchConfig& config);

/// The confidence alone, by some of the points.
[[nodiscard]] double confidenceAt(SurfaceModel& reference, const SomePoints& scan,
                                  const geometry::Pose2& T_reference_scan,
                                  const MatchConfig& config);

}  // namespace omega_slam::matching

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// Directions in which two scans are compared, evenly spaced over the full turn: as many as the
/// Hokuyo URG-04LX has beams in a turn.
inline constexpr int kRayDirections = 1024;

/// Ranges in these directions [m].
using RayRanges = Eigen::Array<float, kRayDirections, 1>;

/// A scan made ready to be looked at from elsewhere: its points, joined to lines where neighbours
/// lie on one surface. Neighbours do so if no farther apart than 0.05 m and a tenth of their range:
/// beams of up to a few degrees that meet a wall at a slant still join, the edges of a desk and the
/// wall behind it do not.
class RayScan {
 public:
  /// @param scan any points, also none or NaN
  /// @param most_points keep about so many, for speed: every n-th of each line, and its ends
  explicit RayScan(const View& scan,
                   std::size_t most_points = std::numeric_limits<std::size_t>::max());

  struct Vertex {
    Eigen::Vector2d p_scan;  ///< [m]
    bool joined;             ///< to the vertex before it
    bool lone;               ///< joined to none
  };
  [[nodiscard]] const std::vector<Vertex>& vertices() const { return vertices_; }

  /// In how many of the directions something is seen from the scan's own origin.
  [[nodiscard]] double rays() const { return rays_; }

 private:
  void addLine(const Points& points, std::size_t begin, std::size_t end, std::size_t stride);

  std::vector<Vertex> vertices_;
  double rays_{0.0};
};

/// The paper's measure of how ill two scans fit (section 6.4, "ScanMatching"): one scan is mapped
/// into the coordinate frame of the other, the two are compared ray by ray, and the error is the
/// squared difference. Here, the mean of it over the compared rays [m^2].
///
/// Rays begin at the origin of the reference's newest view, in kRayDirections directions. A ray's
/// range is that of the nearest line or lone point there, as a laser would measure it, so what is
/// hidden from that place takes no part. Where the newest view sees something, this counts for the
/// reference, even if an older view has seen something nearer: the newest laser has looked through
/// it. Elsewhere the older views fill in, the nearest of them.
///
/// The paper does not say what becomes of rays that only one of the two has, or of outliers. Here:
/// - A difference counts no more than `cap`.
/// - A ray that only one of the two has is not compared: the other may not have looked there, or
///   its beam may have met nothing within its range. It says nothing about the pose, and an error
///   for it would pull towards the largest overlap, away from the truth.
/// - But at least 70 % of the rays of the scan that has fewer must be compared; those that lack
///   count with the cap. No overlap at all is the largest error, the cap's square.
///
/// So the error lies in [0, cap^2] for any pose, one that is not finite included, and is 0 for a
/// scan and itself at the identity. It is not symmetric: exchanging the two looks from another
/// place. Where both were taken from one place, it is so up to the interpolation between beams.
///
/// Thread-safe: any number of threads may ask.
class RayReference {
 public:
  /// @param cap [m], > 0, of the difference of two ranges. 1 m leaves the error nearly that of the
  ///   paper; a matcher chooses a smaller one, so that edges do not outvote walls.
  explicit RayReference(const Reference& reference, double cap = 1.0);

  /// Mean squared difference of the ranges [m^2], of a scan at a pose. Linear in the points.
  [[nodiscard]] double squaredError(const RayScan& scan,
                                    const geometry::Pose2& T_reference_scan) const;

 private:
  double cap_;
  /// The frame of the directions: at the newest view's origin, the first direction towards its
  /// first return, so that the error does not depend on how the reference's frame is turned.
  geometry::Pose2 T_center_reference_;
  RayRanges ranges_;
  double rays_{0.0};
};

}  // namespace omega_slam::matching

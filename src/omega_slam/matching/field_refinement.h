#pragma once

#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/match_quality.h"
#include "omega_slam/matching/point_to_line.h"
#include "omega_slam/matching/surface_field.h"

namespace omega_slam::matching {

struct Refinement {
  geometry::Pose2 T_reference_scan;
  bool converged{false};  ///< before the iterations ran out
};

/// A scan on a distance field: carries a pose that is right to a few centimetres the last of them,
/// by Gauss-Newton steps as Kohlbrecher et al. 2011 ("A flexible and scalable SLAM system with full
/// 3D motion estimation", SSRR) take them on a field of occupancy, but from points to surfaces and
/// with robust weights. Returns beside what is neither a line nor a spot don't pull.
class FieldRefinement {
 public:
  /// @param scan patches of the scan, in its frame; must outlive this, as must the field
  FieldRefinement(const SurfaceField& field, const std::vector<SurfacePatch>& scan)
      : field_(field), scan_(scan) {}

  /// @param start `T_reference_scan`; the result where nothing is in reach
  /// @param hold  what open directions lead back to: see stepToLeastSquares
  /// @param range_noise [m] standard deviation of a range
  [[nodiscard]] Refinement refine(const geometry::Pose2& start, const geometry::Pose2& hold,
                                  double range_noise, int max_iterations) const;

  /// The distances around a pose, as Gauss and Newton see them.
  [[nodiscard]] PointToLineEquations linearize(const geometry::Pose2& T_reference_scan,
                                               const DistanceKernel& kernel) const;

  /// What they say of the pose.
  [[nodiscard]] MatchEvidence evidence(const geometry::Pose2& T_reference_scan) const;

 private:
  const SurfaceField& field_;
  const std::vector<SurfacePatch>& scan_;
};

}  // namespace omega_slam::matching

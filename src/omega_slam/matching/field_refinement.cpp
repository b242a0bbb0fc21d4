#include "omega_slam/matching/field_refinement.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr double kTolerance = 2.0;      // in standard deviations of a range
constexpr double kSmallestStep = 3e-4;  // [m], [rad] well below what a laser tells
constexpr double kCalming = 0.7;        // of steps, once one takes back the last

/// Calls `visit(surface, gap, arm, facing)` for each return that has a partner: see
/// MatchEvidence::add.
template <class Visitor>
void forEachPartner(const SurfaceField& field, const std::vector<SurfacePatch>& scan,
                    const Pose2& T_reference_scan, const Visitor& visit) {
  const Eigen::Matrix2d rotation = T_reference_scan.rotation();
  const Eigen::Vector2d translation = T_reference_scan.translation();
  for (const SurfacePatch& patch : scan) {
    const Eigen::Vector2d arm = rotation * patch.hit;
    const Eigen::Vector2d p_reference = arm + translation;
    const Eigen::Vector2d facing = rotation * patch.surface.normal;
    if (const auto partner = field.partnerOf(p_reference, facing)) {
      visit(partner->surface, p_reference - partner->point, arm, facing);
    }
  }
}

}  // namespace

Refinement FieldRefinement::refine(const Pose2& start, const Pose2& hold, double range_noise,
                                   int max_iterations) const {
  // The field has a reach of its own.
  const DistanceKernel kernel{0.0, range_noise, kTolerance * range_noise};
  Refinement refinement{start, false};
  Pose2& pose = refinement.T_reference_scan;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  double calm = 1.0;
  for (int i = 0; i < max_iterations && !refinement.converged; ++i) {
    Eigen::Vector3d step = calm * stepToLeastSquares(linearize(pose, kernel), pose, hold);
    if (step.dot(last) < 0.0) {
      // Points that change partners to and fro would have it go on for ever.
      calm *= kCalming;
      step *= kCalming;
    }
    last = step;
    pose = Pose2::fromVector(pose.vector() + step);
    refinement.converged = step.cwiseAbs().maxCoeff() < kSmallestStep;
  }
  return refinement;
}

PointToLineEquations FieldRefinement::linearize(const Pose2& T_reference_scan,
                                                const DistanceKernel& kernel) const {
  PointToLineEquations equations;
  forEachPartner(field_, scan_, T_reference_scan,
                 [&](const Surface& surface, const Eigen::Vector2d& gap, const Eigen::Vector2d& arm,
                     const Eigen::Vector2d& /*facing*/) {
                   // What is neither would tie the scan to where beams happened to fall.
                   if (surface.isLine() || surface.is_spot) {
                     equations.add(surface, gap, arm, kernel);
                   }
                 });
  return equations;
}

MatchEvidence FieldRefinement::evidence(const Pose2& T_reference_scan) const {
  MatchEvidence evidence;
  evidence.points = scan_.size();
  forEachPartner(field_, scan_, T_reference_scan,
                 [&](const Surface& surface, const Eigen::Vector2d& gap, const Eigen::Vector2d& arm,
                     const Eigen::Vector2d& facing) { evidence.add(surface, gap, arm, facing); });
  return evidence;
}

}  // namespace omega_slam::matching

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "omega_slam/matching/point_index.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// What the points around a place form: a line, a spot, or nothing in particular.
struct Surface {
  /// Of the line, unit; zero where there is none. Where it is known from where the surface was
  /// seen, it points to that side.
  Eigen::Vector2d normal{0.0, 0.0};
  double slope_variance{0.0};  ///< of the normal's direction [rad^2]
  bool is_spot{false};         ///< no line, but points close together, as of a table's leg

  [[nodiscard]] bool isLine() const { return normal.squaredNorm() > 0.0; }

  /// What it says of where a point on it lies, in units of a range's information: n n^T for a line,
  /// which is free along itself. Elsewhere the partner itself says it, which is as noisy as the
  /// point: half the identity.
  [[nodiscard]] Eigen::Matrix2d information() const {
    if (isLine()) {
      return normal * normal.transpose();
    }
    return 0.5 * Eigen::Matrix2d::Identity();
  }

  /// What a line pretends to know along itself. Noise tilts the normals: s^2 t t^T on average, with
  /// the tangent t and the slope's variance s^2; three times that, since neighbours tilt together.
  /// Where the point's own surface is known and lies otherwise, as a bare wall does on a line that
  /// was drawn across a step, the line is off by at least that.
  /// @param facing normal of the point's own surface; zero where it is not known
  [[nodiscard]] double doubt(const Eigen::Vector2d& facing = Eigen::Vector2d::Zero()) const {
    const double sine = normal.x() * facing.y() - normal.y() * facing.x();
    return 3.0 * std::max(slope_variance, sine * sine);
  }
};

/// How far along a direction a point of the scan moves with the scan's pose (x, y, theta), to first
/// order: the derivatives.
/// @param arm [m] from the scan's origin to the point; in the axes of the direction
[[nodiscard]] inline Eigen::Vector3d byPose(const Eigen::Vector2d& direction,
                                            const Eigen::Vector2d& arm) {
  return {direction.x(), direction.y(), arm.x() * direction.y() - arm.y() * direction.x()};
}

/// What is known of a point's place, as what is thereby known of the pose (x, y, theta) of the scan
/// that it belongs to: J^T I J with the derivatives J of its place by the pose.
/// @param information symmetric
/// @param arm [m] from the scan's origin to the point, in the axes of the information
[[nodiscard]] inline Eigen::Matrix3d poseInformation(const Eigen::Matrix2d& information,
                                                     const Eigen::Vector2d& arm) {
  const Eigen::Vector2d turned = information * Eigen::Vector2d(-arm.y(), arm.x());
  const double about = arm.x() * turned.y() - arm.y() * turned.x();
  Eigen::Matrix3d on_pose;
  on_pose << information(0, 0), information(0, 1), turned.x(),  //
      information(1, 0), information(1, 1), turned.y(),         //
      turned.x(), turned.y(), about;
  return on_pose;
}

/// The part of what a point's partner says of the pose to build on: what a line pretends to know
/// along itself is taken off. Where points form neither a line nor a spot, as at the end of a wall
/// that the laser sees no farther, nothing is left.
/// @param arm [m] from the scan's origin to the point
/// @param facing normal of the point's own surface; zero where it is not known
[[nodiscard]] inline Eigen::Matrix3d certainInformation(
    const Surface& surface, const Eigen::Vector2d& arm,
    const Eigen::Vector2d& facing = Eigen::Vector2d::Zero()) {
  if (surface.isLine()) {
    const Eigen::Vector2d tangent(-surface.normal.y(), surface.normal.x());
    const Eigen::Vector3d across = byPose(surface.normal, arm);
    const Eigen::Vector3d along = byPose(tangent, arm);
    return across * across.transpose() - surface.doubt(facing) * along * along.transpose();
  }
  return surface.is_spot ? poseInformation(surface.information(), arm) : Eigen::Matrix3d::Zero();
}

/// The line that fits points best, from what they sum up to: total least squares. None for fewer
/// than three points, or a heap, which is a spot if it is small.
/// @param scatter [m^2] sum of d d^T for the points' offsets d from their mean
[[nodiscard]] Surface fitSurface(const Eigen::Matrix2d& scatter, std::size_t count);

/// Every `stride`-th of a scan's points, by the numbers that they have among all: what a
/// SurfaceModel has found for them still helps when all are asked for.
struct SomePoints {
  const View& view;
  std::size_t stride{1};

  [[nodiscard]] std::size_t size() const { return (view.points.size() + stride - 1) / stride; }
};

/// Enough where a few hundred more of the same walls say the same.
/// @param most > 0
[[nodiscard]] inline SomePoints someOf(const View& view, std::size_t most) {
  return {view, (view.points.size() + most - 1) / most};
}

/// The points of a reference as the surfaces that they were measured on: for each point the line
/// through its neighbours in the sweep within 0.3 m. Where that is too few, as far away or among
/// points without order, the line through all points within 0.3 m, or through the two neighbours
/// in the sweep where they lie straight. A surface is fitted when it is first asked for.
///
/// Not thread-safe.
class SurfaceModel {
 public:
  /// @param reference views of finite points, each in the order of its sweep
  explicit SurfaceModel(const Reference& reference);
  SurfaceModel(const SurfaceModel&) = delete;  // the index is of this one's points
  SurfaceModel& operator=(const SurfaceModel&) = delete;

  struct Partner {
    /// [m] on the line, where there is one; else the reference's point
    Eigen::Vector2d point{0.0, 0.0};
    Surface surface;

    /// Whether it could be the side of the surface that is seen from there, however wide the view:
    /// a thin wall has another one, which is not where this one is. Edge-on nobody can tell.
    /// @param eye [m] in the reference's frame
    [[nodiscard]] bool isSeenFrom(const Eigen::Vector2d& eye) const;
  };

  /// The surface of the reference point nearest to a place, none if it is farther than `reach` [m].
  [[nodiscard]] std::optional<Partner> partnerOf(const Eigen::Vector2d& p_reference, double reach);

  /// The same for a point of a scan that is asked for again and again while the scan moves little:
  /// most are then known to have the same nearest point as the last time (as in Greenspan and Godin
  /// 2001, "A nearest neighbor method for efficient ICP", 3DIM), and no search is needed.
  /// @param point its number, the same each time; any number will do, but a wrong one takes longer
  /// @return none: nullptr. Valid as long as the model
  [[nodiscard]] const Partner* partnerOf(std::size_t point, const Eigen::Vector2d& p_reference,
                                         double reach);

  /// Calls `visit(i, partner, gap, arm)` for the points of a scan, laid on the reference, that have
  /// a partner within reach [m], whose side the scan could see. `gap` [m] leads from the partner to
  /// point `i`, `arm` [m] from the scan's origin to it; both are in the reference's axes.
  template <class Visitor>
  void forEachPartner(const SomePoints& scan, const geometry::Pose2& T_reference_scan, double reach,
                      const Visitor& visit);

 private:
  /// What was found for a point of a scan.
  struct Finding {
    Eigen::Vector2d place{0.0, 0.0};  ///< [m] where it was
    std::size_t nearest{0};           ///< of the reference's points
    double clearance{0.0};            ///< [m] around the place, in which there is no other
    double slack{-1.0};  ///< [m] as long as the point has moved by less, that one is the nearest
  };

  void search(Finding& finding, const Eigen::Vector2d& p_reference, double reach) const;
  [[nodiscard]] const Partner* surfaceAt(std::size_t index);
  void turnToEye(std::size_t index, Partner& partner) const;
  [[nodiscard]] Partner fitAround(std::size_t index);
  [[nodiscard]] Partner fitSweep(std::size_t index) const;
  [[nodiscard]] Partner fitNeighbourhood(std::size_t index);
  [[nodiscard]] Partner fitSparse(std::size_t index) const;

  /// The views follow each other in the points.
  struct Eye {
    std::size_t end{0};  ///< index after its last point
    Eigen::Vector2d place{0.0, 0.0};
  };

  Points reference_;
  std::vector<Eye> eyes_;
  PointIndex index_;
  std::size_t latest_{0};          // of the nearest points: where the next one is likely to be
  std::vector<Finding> findings_;  // by the points' numbers
  std::vector<std::optional<Partner>> partners_;
  std::vector<PointIndex::Neighbour> neighbours_;  // kept, so as not to allocate for each point
};

template <class Visitor>
void SurfaceModel::forEachPartner(const SomePoints& scan, const geometry::Pose2& T_reference_scan,
                                  double reach, const Visitor& visit) {
  const Eigen::Matrix2d rotation = T_reference_scan.rotation();
  const Eigen::Vector2d translation = T_reference_scan.translation();
  const Eigen::Vector2d eye = T_reference_scan * scan.view.origin;
  for (std::size_t i = 0; i < scan.view.points.size(); i += scan.stride) {
    const Eigen::Vector2d arm = rotation * scan.view.points[i];
    const Eigen::Vector2d p_reference = arm + translation;
    const Partner* const partner = partnerOf(i, p_reference, reach);
    if (partner != nullptr && partner->isSeenFrom(eye)) {
      visit(i, *partner, p_reference - partner->point, arm);
    }
  }
}

}  // namespace omega_slam::matching

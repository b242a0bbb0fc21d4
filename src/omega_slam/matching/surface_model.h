#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "omega_slam/matching/point_index.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// What the points around a place form: a line, a spot, or nothing in particular.
struct Surface {
  Eigen::Vector2d normal{0.0, 0.0};  ///< of the line, unit; zero where there is none
  double slope_variance{0.0};        ///< of the normal's direction [rad^2]
  bool is_spot{false};               ///< no line, but points close together, as of a table's leg

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

  /// The part of it to build on. Noise tilts the normals, and what is tilted pretends to know
  /// something along the wall, which is taken off: see doubt(). Where points form neither a line
  /// nor a spot, as at the end of a wall that the laser sees no farther, nothing is left.
  [[nodiscard]] Eigen::Matrix2d certainInformation() const {
    if (isLine()) {
      const Eigen::Vector2d tangent(-normal.y(), normal.x());
      return information() - doubt() * tangent * tangent.transpose();
    }
    return is_spot ? information() : Eigen::Matrix2d::Zero();
  }

  /// What a line pretends to know along itself: s^2 t t^T on average, with the tangent t and the
  /// slope's variance s^2; three times that, since neighbours tilt together.
  [[nodiscard]] double doubt() const { return 3.0 * slope_variance; }
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

/// The line that fits points best, from what they sum up to: total least squares. None for fewer
/// than three points, or a heap, which is a spot if it is small.
/// @param scatter [m^2] sum of d d^T for the points' offsets d from their mean
[[nodiscard]] Surface fitSurface(const Eigen::Matrix2d& scatter, std::size_t count);

/// The points of a reference as the surfaces that they were measured on: for each point the line
/// through its neighbours in the sweep within 0.3 m. Where that is too few, as far away or among
/// points without order, the line through all points within 0.3 m, or through the two neighbours
/// in the sweep where they lie straight. A surface is fitted when it is first asked for.
///
/// The points must outlive the model. Not thread-safe.
class SurfaceModel {
 public:
  /// @param reference views one after the other, each in the order of its sweep; finite
  explicit SurfaceModel(const Points& reference);

  struct Partner {
    /// [m] on the line, where there is one; else the reference's point
    Eigen::Vector2d point{0.0, 0.0};
    Surface surface;
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
  [[nodiscard]] Partner fitAround(std::size_t index);
  [[nodiscard]] Partner fitSweep(std::size_t index) const;
  [[nodiscard]] Partner fitNeighbourhood(std::size_t index);
  [[nodiscard]] Partner fitSparse(std::size_t index) const;

  const Points& reference_;
  PointIndex index_;
  std::size_t latest_{0};          // of the nearest points: where the next one is likely to be
  std::vector<Finding> findings_;  // by the points' numbers
  std::vector<std::optional<Partner>> partners_;
  std::vector<PointIndex::Neighbour> neighbours_;  // kept, so as not to allocate for each point
};

}  // namespace omega_slam::matching

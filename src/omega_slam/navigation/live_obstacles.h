#pragma once

#include <Eigen/Core>
#include <vector>

#include "omega_slam/grid/distance_field.h"
#include "omega_slam/navigation/sighting.h"

namespace omega_slam::navigation {

/// Obstacles that sensors have seen near the robot lately, whether or not they are in the map, on a
/// square of cells that moves along with the robot. Times are the caller's: there is no clock here.
///
/// A cell is marked where a beam ends, and free again when a later beam passes through it, or when
/// nothing has marked it for `memory`. Not thread-safe.
class LiveObstacles {
 public:
  /// @param resolution [m] of the cells; @param reach [m] from the robot to the square's edge
  LiveObstacles(double resolution, double reach);

  /// Moves the square to be about a point [m]; what falls off its edge is forgotten.
  void center(const Eigen::Vector2d& point);

  /// @param sighting in the map; @param memory [s] for which a mark lasts without another
  void see(const Sighting& sighting, double memory);

  /// Lets time pass: marks that have lasted long enough are dropped.
  void expire(double now);

  void forget();

  /// Distances to all that is remembered. Outside of the square nothing is known, and free.
  [[nodiscard]] const grid::DistanceField& field() const { return field_; }

 private:
  [[nodiscard]] grid::GridGeometry squareAbout(const Eigen::Vector2d& point) const;
  [[nodiscard]] Eigen::Vector2d clipped(const Eigen::Vector2d& origin,
                                        const Eigen::Vector2d& end) const;
  [[nodiscard]] bool drop(double now);  ///< what has lasted long enough; whether there was any
  void clearAlong(const Eigen::Vector2d& origin, const Eigen::Vector2d& end);
  void rebuild();

  double reach_;
  grid::GridGeometry geometry_;
  std::vector<double> until_;  ///< [s] a cell: when its mark is dropped; 0: not marked
  grid::DistanceField field_;
};

}  // namespace omega_slam::navigation

#pragma once

#include <Eigen/Core>
#include <vector>

#include "omega_slam/geometry/map_motion.h"
#include "omega_slam/grid/distance_field.h"

namespace omega_slam::navigation {

/// Where the robot has bumped into something, near it or not: no plan is to lead through there. No
/// beam clears these places, since what the robot bumps into is what its laser can't see. Times are
/// the caller's. Not thread-safe.
class Contacts {
 public:
  explicit Contacts(double resolution);  ///< [m] of the cells that are marked

  /// What is farther than 100 m from a new one is forgotten.
  /// @param points [m] in the map; @param until [s] time at which they are forgotten
  void add(const std::vector<Eigen::Vector2d>& points, double until);
  void move(const geometry::MapMotion& motion);  ///< with the keyframes that they were near to
  void expire(double now);                       ///< drops those that have lasted long enough
  void forget();

  /// Distances to all of them.
  [[nodiscard]] const grid::DistanceField& field() const { return field_; }

 private:
  struct Mark {
    Eigen::Vector2d point;  ///< [m] in the map, not rounded: the map moves by less than a cell
    double until;           ///< [s]
  };

  template <typename Predicate>
  bool drop(Predicate&& is_old);  ///< whether there was any
  void rebuild();

  grid::GridGeometry lattice_;  ///< that cells are counted on, from the map's origin
  std::vector<Mark> marks_;     ///< one a cell, until they move
  grid::DistanceField field_;   ///< as large as it must be to hold the marks
};

}  // namespace omega_slam::navigation
